#pragma once

#include <Eigen/Core>
#include <random>
#include <string>

#include "model/model.hpp"
#include "model/scan.hpp"

/// Scans made for tests, in model axes (mm) and without normals unless said otherwise.
namespace bodyline::optimize {

/// Draws that are the same with every standard library.
class SampleDraw {
 public:
  explicit SampleDraw(unsigned seed) : generator_(seed + 1000) {}
  double uniform();  ///< in [0, 1)
  double normal();
  std::size_t below(std::size_t count) { return std::size_t(generator_() % count); }
  Eigen::Vector3d normal_vector();
  Eigen::Vector3d in_box();  ///< in [-1, 1)^3
  Eigen::Matrix3d rotation();

 private:
  std::mt19937_64 generator_;
};

/// `count` points on a body, evenly, with Gaussian noise along each axis.
model::Scan sampled(const model::Model& car, int count, double noise_mm, SampleDraw& draw);

/// The scan that `pose` takes to `in_model_axes`.
model::Scan scanned_from(const model::Scan& in_model_axes, const model::Pose& pose);

/// The points of a scan without normals that satisfy `condition`.
template <class Condition>
model::Scan kept(const model::Scan& scan, const Condition& condition) {
  model::Scan result;
  for (const Eigen::Vector3d& point : scan.points)
    if (condition(point)) result.points.push_back(point);
  return result;
}

/// Adds points in a box 1.2 times as large as the scan's, until they are that share of all.
void add_outliers(model::Scan& scan, double share, SampleDraw& draw);
void add_wheels_and_mirrors(model::Scan& scan, SampleDraw& draw);
/// Adds half as many points again on a plane 200 mm below the body and wider than it.
void add_ground(model::Scan& scan, SampleDraw& draw);
void cut_holes(model::Scan& scan, int count, double radius, SampleDraw& draw);

model::Scan flat_plane(SampleDraw& draw);
model::Scan ellipsoid(const Eigen::Vector3d& radii, SampleDraw& draw);
model::Scan box_surface(const Eigen::Vector3d& half, SampleDraw& draw);
/// A sitting body, a head and two long ears, 4 m long before it is stretched.
model::Scan bunny_like(const Eigen::Vector3d& stretch, SampleDraw& draw);

/// The scans of real cars beside the repository, with normals.
bool have_scan(const std::string& name);
model::Scan read_test_scan(const std::string& name);

}  // namespace bodyline::optimize
