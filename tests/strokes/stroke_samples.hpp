#pragma once

#include <array>
#include <functional>
#include <vector>

#include "model/random.hpp"
#include "strokes/surface_model.hpp"

/// Strokes and surfaces that several tests need.
namespace bodyline::test {

using Points = std::vector<Eigen::Vector3d>;

/// Points of a curve at `count` even parameters from 0 to 1.
Points sampled(int count, const std::function<Eigen::Vector3d(double)>& curve);

/// Points of a straight line.
Points line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int count);

/// Four straight sides around a rectangle of the plane z = 0, counter-clockwise from the origin.
std::vector<Points> rectangle(double width, double depth, int points_per_side);

/// A rough boundary of three or four bowed sides, about 1000 mm across.
std::vector<Points> random_boundary(model::Random& random);

/// A stroke over such a boundary: it may be straight or bent, lie on the surface or above it, and
/// end anywhere, also outside.
model::Stroke random_stroke(model::Random& random);

/// A smooth boundary of three or four sides in a surface of low waves, about 1000 mm across, and
/// strokes over it; all points are within half of `gentle_noise_mm` of the surface. `random` is
/// used for the waves first, so that a boundary and strokes of one seed belong together.
class GentleDrawing {
 public:
  explicit GentleDrawing(std::uint64_t seed);
  std::vector<Points> boundary();
  model::Stroke stroke();

 private:
  Eigen::Vector3d on_surface(double x, double y);
  Eigen::Vector3d noisy(const Eigen::Vector3d& point);

  model::Random random_;
  bool triangle_ = false;
  Points corners_;
  std::array<double, 6> waves_{};
};
inline constexpr double gentle_noise_mm = 0.2;

/// What a random boundary and strokes make; thresholds of 6 mm.
strokes::SurfaceModel random_surface(std::uint64_t seed, int strokes);

inline constexpr double random_threshold_mm = 6.0;

}  // namespace bodyline::test
