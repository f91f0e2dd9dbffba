#include "optimize/simulate_scan.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "model/build.hpp"
#include "optimize/body_sampler.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr std::size_t fewest_points = 100, most_points = 50'000'000;
constexpr double largest_noise = 1000.0, most_outliers = 0.9;
constexpr double box_growth = 1.2;
// Radii of empty balls as parts of the body's diagonal: some 15 to 50 cm on a car.
constexpr double smallest_hole = 0.03, largest_hole = 0.1;

bool is_between(double value, double lower, double upper) {
  return value >= lower && value <= upper;  // NaN is not
}

void check_options(const SimulateOptions& options) {
  if (options.points < fewest_points || options.points > most_points) {
    throw std::invalid_argument("a scan is simulated with 100 to 50000000 points, not with " +
                                std::to_string(options.points));
  }
  if (!is_between(options.noise_mm, 0.0, largest_noise)) {
    throw std::invalid_argument("the noise must be from 0 to 1000 mm");
  }
  if (!is_between(options.outliers, 0.0, most_outliers)) {
    throw std::invalid_argument("the part of outliers must be from 0 to 0.9");
  }
  model::check_pose(options.pose);
}

Vector3d normal_vector(model::Random& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

model::Scan points_on_body(const BodySampler& body, const SimulateOptions& options,
                           model::Random& random) {
  model::Scan scan;
  for (std::size_t k = 0; k < options.points; ++k) {
    const FacePoint at = body.next(random);
    scan.points.emplace_back(at.position + options.noise_mm * normal_vector(random));
    scan.normals.push_back(model::outward_normal(body.faces()[at.face], at.u, at.v));
  }
  return scan;
}

Eigen::AlignedBox3d box_of(const model::Scan& scan) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : scan.points) box.extend(point);
  return box;
}

// Exactly the part asked for, anywhere in the order of the points.
void scatter_outliers(model::Scan& scan, double part, model::Random& random) {
  const Eigen::AlignedBox3d box = box_of(scan);
  const Vector3d sizes = box_growth * box.sizes();
  auto left = static_cast<std::size_t>(std::llround(part * double(scan.points.size())));
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    if (random.below(scan.points.size() - k) >= left) continue;
    --left;
    for (int c = 0; c < 3; ++c) {
      scan.points[k][c] = box.center()[c] + (random.uniform() - 0.5) * sizes[c];
    }
    scan.normals[k] = random.direction();
  }
}

template <typename Predicate>
void remove_points(model::Scan& scan, const Predicate& is_gone) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    if (is_gone(scan.points[k])) continue;
    scan.points[kept] = scan.points[k];
    scan.normals[kept++] = scan.normals[k];
  }
  scan.points.resize(kept);
  scan.normals.resize(kept);
}

void remove_holes(model::Scan& scan, model::Random& random) {
  const double diagonal = box_of(scan).diagonal().norm();
  const std::size_t half = scan.points.size() / 2;
  while (scan.points.size() > half) {
    const Vector3d center = scan.points[random.below(scan.points.size())];
    const double part = smallest_hole + (largest_hole - smallest_hole) * random.uniform();
    const double squared_radius = part * diagonal * part * diagonal;
    remove_points(scan, [&](const Vector3d& point) {
      return (point - center).squaredNorm() <= squared_radius;
    });
  }
}

void remove_missing(model::Scan& scan, Missing missing, model::Random& random) {
  if (missing == Missing::left) {
    remove_points(scan, [](const Vector3d& point) { return point.y() < 0.0; });
  } else if (missing == Missing::holes) {
    remove_holes(scan, random);
  }
}

void take_to_scan(model::Scan& scan, const model::Pose& pose) {
  for (Vector3d& point : scan.points) point = model::to_scan(pose, point);
  for (Vector3d& normal : scan.normals) normal = (pose.rotation.transpose() * normal).eval();
}

}  // namespace

const char* missing_name(Missing missing) {
  switch (missing) {
    case Missing::none:
      return "none";
    case Missing::left:
      return "left";
    case Missing::holes:
      return "holes";
  }
  return "";
}

Missing missing_from_name(const std::string& name) {
  for (const Missing missing : {Missing::none, Missing::left, Missing::holes}) {
    if (name == missing_name(missing)) return missing;
  }
  throw std::invalid_argument("'" + name + "' cannot be missing; left and holes can, or none");
}

model::Scan simulate_scan(const model::Model& model, const SimulateOptions& options) {
  check_options(options);
  const BodySampler body(model::build(model, model::Stage::body, model::Halves::both));
  model::Random random(options.seed);
  model::Scan scan = points_on_body(body, options, random);
  scatter_outliers(scan, options.outliers, random);
  remove_missing(scan, options.missing, random);
  take_to_scan(scan, options.pose);
  return scan;
}

}  // namespace bodyline::optimize
