#pragma once

#include <memory>

#include "model/elevation.hpp"
#include "model/family.hpp"

namespace bodyline::model {

/// What does not change while a patch of any family is shaped: its bases, and the matrices that
/// raise Bezier points to the degrees of its net.
struct ShapedPatch {
  /// Degrees of the curves and of the net, as `connect` derives them.
  ShapedPatch(const std::string& family, int m, int n, int net_m, int net_n);

  /// Where the shape parameters of row i begin among those along v; they are
  /// basis_v->shape_count().
  int row_shape(int i) const { return shape_per_row ? i * basis_v->shape_count() : 0; }

  int m, n, net_m, net_n;
  bool shape_per_row;
  std::unique_ptr<const AnyBasis> basis_u, basis_v;
  FormMatrix raise_u, raise_v;  ///< (net degree + 1) x (degree + 1)
  FormMatrix raise_abscissa_u, raise_abscissa_v;
  FormMatrix raise_row;  ///< Bezier points of a row's basis; empty unless shape_per_row
};

/// The shape parameters of a patch of the largest degrees, along one direction.
inline constexpr int max_shape_values = max_patch_degree + 1;

}  // namespace bodyline::model
