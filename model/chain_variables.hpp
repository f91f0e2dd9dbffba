#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/patch_chain.hpp"

namespace bodyline::model {

enum class ChainKind { shape, ratio, slide, point };

/// A number of a chain that may change while every join holds: shape parameters that joins tie
/// together count as one.
struct ChainVariable {
  std::string name;  ///< shape.PATCH.u[k], ratio.PATCH, slide.PATCH or point.PATCH[i][j].x; the
                     ///< ratio and slide are those of the join to the patch before
  ChainKind kind = ChainKind::shape;
  std::vector<int> members;         ///< positions in the ChainLayout; all have the same value
  double lower = 0.0, upper = 0.0;  ///< in which it may be sought; -inf, inf for points
  /// The joins hold even if no control point moves (the papers' free shape parameters); otherwise
  /// `propagate` moves the determined rows.
  bool points_stay = false;
};

/// All of them: shape parameters, then ratios and slides, then the coordinates of the points that
/// no join determines. Throws as `propagate`.
std::vector<ChainVariable> chain_variables(const PatchChain& chain);

}  // namespace bodyline::model
