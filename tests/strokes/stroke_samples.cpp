#include "tests/strokes/stroke_samples.hpp"

#include <cmath>
#include <numbers>

#include "strokes/add_stroke.hpp"
#include "strokes/base_net.hpp"

namespace bodyline::test {

using Eigen::Vector2d;
using Eigen::Vector3d;

Points sampled(int count, const std::function<Vector3d(double)>& curve) {
  Points points;
  for (int k = 0; k < count; ++k) points.push_back(curve(static_cast<double>(k) / (count - 1)));
  return points;
}

Points line(const Vector3d& from, const Vector3d& to, int count) {
  return sampled(count, [&](double t) { return Vector3d((1.0 - t) * from + t * to); });
}

std::vector<Points> rectangle(double width, double depth, int points_per_side) {
  const Points corners{{0, 0, 0}, {width, 0, 0}, {width, depth, 0}, {0, depth, 0}};
  std::vector<Points> loop;
  for (int k = 0; k < 4; ++k)
    loop.push_back(line(corners[k], corners[(k + 1) % 4], points_per_side));
  return loop;
}

std::vector<Points> random_boundary(model::Random& random) {
  const bool triangle = random.uniform() < 0.25;
  Points corners = triangle ? Points{{0, 0, 0}, {1000, 0, 0}, {500, 800, 0}}
                            : Points{{0, 0, 0}, {1000, 0, 0}, {1000, 700, 0}, {0, 700, 0}};
  const auto spread = [&random](double x, double y, double z) {
    return Vector3d(x * (2.0 * random.uniform() - 1.0), y * (2.0 * random.uniform() - 1.0),
                    z * (2.0 * random.uniform() - 1.0));
  };
  for (Vector3d& corner : corners) corner += spread(60, 60, 60);
  std::vector<Points> loop;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3d from = corners[k], to = corners[(k + 1) % corners.size()];
    const Vector3d bow = spread(40, 40, 150);
    loop.push_back(sampled(5 + static_cast<int>(random.below(20)), [&](double t) {
      return Vector3d((1.0 - t) * from + t * to + 4.0 * t * (1.0 - t) * bow);
    }));
  }
  return loop;
}

model::Stroke random_stroke(model::Random& random) {
  const Vector2d from(random.uniform(), random.uniform());
  const double angle = 2.0 * std::numbers::pi * random.uniform();
  const Vector2d along =
      (0.15 + 0.5 * random.uniform()) * Vector2d(std::cos(angle), std::sin(angle));
  const Vector2d aside(-along.y(), along.x());
  const double bend = random.uniform() < 0.3 ? 0.2 * random.uniform() - 0.1 : 0.0;
  const double lift = random.uniform() < 0.7 ? 120.0 * random.uniform() - 60.0 : 0.0;
  return {"stroke", sampled(2 + static_cast<int>(random.below(25)), [&](double t) {
            const Vector2d at = from + t * along + 4.0 * t * (1.0 - t) * bend * aside;
            const double height = 100.0 * std::sin(3.0 * at.x()) * std::sin(3.0 * at.y());
            return Vector3d(1000.0 * at.x(), 700.0 * at.y(),
                            height + lift * std::sin(std::numbers::pi * t));
          })};
}

GentleDrawing::GentleDrawing(std::uint64_t seed) : random_(seed) {
  triangle_ = random_.uniform() < 0.25;
  corners_ = triangle_ ? Points{{0, 0, 0}, {1000, 0, 0}, {500, 800, 0}}
                       : Points{{0, 0, 0}, {1000, 0, 0}, {1000, 700, 0}, {0, 700, 0}};
  for (Vector3d& corner : corners_)
    corner += 80.0 * Vector3d(random_.uniform() - 0.5, random_.uniform() - 0.5, 0.0);
  for (double& wave : waves_) wave = 2.0 * random_.uniform() - 1.0;
}

// Waves of 40 mm height and 800 mm length or more.
Vector3d GentleDrawing::on_surface(double x, double y) {
  return {x, y,
          40.0 * std::sin(0.0035 * x + 3.0 * waves_[0]) * std::sin(0.004 * y + 3.0 * waves_[1]) +
              30.0 * waves_[2] * std::cos(0.006 * (x + waves_[3] * y)) +
              1e-4 * (waves_[4] * x * x + waves_[5] * y * y)};
}

Vector3d GentleDrawing::noisy(const Vector3d& point) {
  const auto noise = [this] { return 0.5 * gentle_noise_mm * (2.0 * random_.uniform() - 1.0); };
  return point + Vector3d(noise(), noise(), noise()) / std::sqrt(3.0);
}

std::vector<Points> GentleDrawing::boundary() {
  std::vector<Points> loop;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Vector3d from = corners_[k], to = corners_[(k + 1) % corners_.size()];
    loop.push_back(sampled(40, [&](double t) {
      const Vector3d at = (1.0 - t) * from + t * to;
      return on_surface(at.x(), at.y());
    }));
  }
  return loop;
}

model::Stroke GentleDrawing::stroke() {
  const auto inside = [this] {
    Vector3d sum = Vector3d::Zero();
    double whole = 0.0;
    for (const Vector3d& corner : corners_) {
      const double weight = 0.1 + random_.uniform();
      sum += weight * corner;
      whole += weight;
    }
    return Vector3d(sum / whole);
  };
  const Vector3d from = inside(), to = inside();
  const Vector3d aside(from.y() - to.y(), to.x() - from.x(), 0.0);
  const double bend = 0.2 * (random_.uniform() - 0.5);
  return {"stroke", sampled(30, [&](double t) {
            const Vector3d at = (1.0 - t) * from + t * to + 4.0 * t * (1.0 - t) * bend * aside;
            return noisy(on_surface(at.x(), at.y()));
          })};
}

strokes::SurfaceModel random_surface(std::uint64_t seed, int strokes) {
  model::Random random(seed);
  strokes::SurfaceModel surface(strokes::base_net(random_boundary(random)));
  strokes::StrokeOptions options;
  options.threshold_mm = random_threshold_mm;
  for (int k = 0; k < strokes; ++k) strokes::add_stroke(surface, random_stroke(random), k, options);
  return surface;
}

}  // namespace bodyline::test
