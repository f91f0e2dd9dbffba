#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "model/face_net.hpp"
#include "model/spline_curve.hpp"
#include "strokes/inner_spline.hpp"
#include "strokes/polygon.hpp"

namespace bodyline::strokes {

/// A point of a patch with derivatives by its parameters.
struct PatchJet {
  Eigen::Vector3d point, s, t, ss, st, tt;
};

/// A patch over its parameters (s, t) in [0,1]^2 that follows four side curves: the bicubically
/// blended Coons patch (eq. 1),
///   S = sum_k f_k(t) P(s,k) + sum_k f_k(s) P(k,t) - sum_kl f_k(s) f_l(t) P(k,l),
///   f_0 = 2x^3 - 3x^2 + 1, f_1 = 3x^2 - 2x^3.
/// With ribbons, which give the derivatives across the sides, it has those too: the same sum with
/// the two cubics that blend derivatives. A displacement inside, which leaves sides and ribbons as
/// they are, may be added. Never changes once made.
class PatchShape {
 public:
  /// Sides and ribbons in the order t = 0, s = 1, t = 1, s = 0, each in the direction of growing s
  /// or t. A ribbon is S_t along t = 0 and t = 1, S_s along s = 0 and s = 1. Ribbons must agree in
  /// their derivatives at the corners (twists). Of a triangle the side t = 1 is a point.
  struct Sides {
    std::array<model::SplineCurve, 4> curves;
    std::array<model::SplineCurve, 4> ribbons;
    bool has_ribbons = false;
  };

  /// `corners` are those of the domain, three or four, as patch_map.hpp takes them.
  PatchShape(Polygon corners, Sides sides, std::shared_ptr<const InnerSpline> inner = nullptr);

  const Polygon& corners() const { return corners_; }
  const Sides& sides() const { return sides_; }

  Eigen::Vector3d point(const Eigen::Vector2d& st) const;
  PatchJet jet(const Eigen::Vector2d& st) const;

  /// The same at a place of the domain, for places in the patch's polygon.
  Eigen::Vector3d point_at(const Eigen::Vector2d& place) const;

  /// The patch in Bezier pieces, exactly.
  model::SplineFace spline_face() const;

 private:
  Polygon corners_;
  Sides sides_;
  std::shared_ptr<const InnerSpline> inner_;
  Eigen::Matrix<Eigen::Vector3d, 4, 4> corner_data_;  // by blending function in s and in t
};

}  // namespace bodyline::strokes
