#include "strokes/gave_way.hpp"

#include <algorithm>

#include "strokes/pull.hpp"

namespace bodyline::strokes {

bool gave_way(const std::vector<StrokeMove>& moves, int stroke, const Eigen::Vector3d& point) {
  return std::any_of(moves.begin(), moves.end(), [&](const StrokeMove& move) {
    return move.stroke == stroke && (point - move.point).norm() < move_spread * move.distance;
  });
}

}  // namespace bodyline::strokes
