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

strokes::SurfaceModel random_surface(std::uint64_t seed, int strokes) {
  model::Random random(seed);
  strokes::SurfaceModel surface(strokes::base_net(random_boundary(random)));
  strokes::StrokeOptions options;
  options.threshold_mm = random_threshold_mm;
  for (int k = 0; k < strokes; ++k) strokes::add_stroke(surface, random_stroke(random), k, options);
  return surface;
}

}  // namespace bodyline::test
