#pragma once

#include <vector>

#include "strokes/points.hpp"

namespace bodyline::strokes {

/// One polyline of a loop.
struct LoopMember {
  int index = 0;          ///< which of the given polylines
  bool reversed = false;  ///< it runs against the loop

  bool operator==(const LoopMember&) const = default;
};

/// The most polylines whose loop is searched for among all orders and directions.
inline constexpr std::size_t most_ordered_exactly = 10;

/// The order and directions in which polylines follow each other with the least sum of gaps from
/// end to begin, around the loop. The first keeps its place and direction. With more than
/// `most_ordered_exactly` the nearest end follows each time.
std::vector<LoopMember> order_loop(const std::vector<Points>& polylines);

/// The polylines in their order, turned into the direction of the loop.
std::vector<Points> ordered(const std::vector<Points>& polylines,
                            const std::vector<LoopMember>& loop);

}  // namespace bodyline::strokes
