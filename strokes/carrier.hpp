#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "strokes/polygon.hpp"
#include "strokes/surface_function.hpp"

namespace bodyline::strokes {

/// Functions over a domain inside the unit square from which displacements are made: cubic
/// B-splines on an even grid of the square, times the product of the distances from the sides of
/// the domain, so that they vanish on its border; squared, with their first derivatives.
struct CarrierBasis {
  static constexpr int at_once = 16;  ///< that do not vanish at a place

  Polygon domain;
  int border_order = 1;  ///< 2: first derivatives vanish on the border, too
  int cells = 8;         ///< of the grid, per direction

  int per_direction() const { return cells + 3; }
  int count() const { return per_direction() * per_direction(); }

  /// The functions at a place: which they are, and by rows their values and derivatives by s, t,
  /// ss, st and tt, in the order of a PatchJet.
  struct Row {
    std::array<int, at_once> index;
    Eigen::Matrix<double, 6, at_once> jet;
  };
  Row row(const Eigen::Vector2d& place) const;
};

/// A smooth surface over a whole domain that carries a net: a base and a displacement of it.
class Carrier {
 public:
  Carrier(SurfaceFunction base, CarrierBasis basis, Eigen::MatrixX3d coefficients)
      : base_(std::move(base)), basis_(std::move(basis)), coefficients_(std::move(coefficients)) {}

  PatchJet jet(const Eigen::Vector2d& place) const;
  const CarrierBasis& basis() const { return basis_; }

 private:
  SurfaceFunction base_;
  CarrierBasis basis_;
  Eigen::MatrixX3d coefficients_;  // mm, by function
};

/// A place of the domain near `place` over which the surface is nearest to a point: downhill from
/// there, within the domain.
Eigen::Vector2d carrier_foot(const Carrier& carrier, Eigen::Vector2d place,
                             const Eigen::Vector3d& point);

}  // namespace bodyline::strokes
