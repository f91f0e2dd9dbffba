#pragma once

#include "model/kernel_lanes.hpp"
#include "model/kernels.hpp"

/// Sum factorisation of a tensor Bezier net: first along u (net -> rows, one for each v index), then along v
/// (rows -> jet at a node), and both steps transposed. `Order` is the highest derivative, 1 to 3.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

constexpr int most_points = 13;  ///< control points per direction
constexpr int block = 8;         ///< nodes along v whose jet adjoints are held at a time

/// Derivatives at `lanes` nodes; a kernel touches only those up to its order.
struct Jet {
  Vector point, u, v, uu, uv, vv, uuu, uuv, uvv, vvv;
};

/// Rows contracted along u: entry [j][a] is the a-th u-derivative of the curve of control points j, as x, y, z.
template <int Order>
struct Rows {
  static constexpr int stride = 3 * (Order + 1);
  Lanes data[most_points * stride];
};

/// The tables of `lanes` nodes along u, starting at node `ku`.
struct Chunk {
  const FaceRule& rule;
  int ku;
  BODYLINE_INLINE Lanes basis(const FaceRule& rule, int ku, int order, int i) = delete;
};

}  // namespace
