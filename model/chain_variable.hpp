#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/family.hpp"

namespace bodyline::model {

enum class ChainKind { shape, ratio, slide, point };

/// A number of a chain that may change while every join holds: shape parameters that joins tie
/// together count as one.
struct ChainVariable {
  std::string name;  ///< of patches shape.PATCH.u[k] and point.PATCH[i][j].x, of curves
                     ///< shape.CURVE[k] and point.CURVE[i].x; ratio.NAME and slide.NAME are those
                     ///< of the join to the patch or curve before
  ChainKind kind = ChainKind::shape;
  std::vector<int> members;         ///< positions in the chain's layout; all have the same value
  double lower = 0.0, upper = 0.0;  ///< in which it may be sought; -inf, inf for points
  /// The joins hold even if no control point moves (the papers' free shape parameters); otherwise
  /// `propagate` moves the determined points.
  bool points_stay = false;
};

/// "[k]", as names of variables count.
std::string index_text(int k);

/// A join's ratio and, with continuity 2, its slide, as variables named after the second of both.
struct JoinNumbers {
  std::string name;
  int continuity = 1;
  double ratio = 1.0, slide = 0.0;
  int ratio_at = 0, slide_at = 0;  ///< positions in the layout
};
void add_join_variables(const JoinNumbers& join, std::vector<ChainVariable>& variables);

/// The three coordinates of a free control point `name` whose first one is `at`.
void add_point_variables(const std::string& name, int at, std::vector<ChainVariable>& variables);

/// Whether the constants of an end (0 or 1) that a join of this continuity needs do not depend on
/// shape parameter k.
bool end_constants_stay(const AnyBasis& basis, std::span<const double> shape, int k, int end,
                        int continuity);

}  // namespace bodyline::model
