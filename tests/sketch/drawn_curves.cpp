#include "tests/sketch/drawn_curves.hpp"

#include <algorithm>
#include <random>

#include "sketch/curve_jet.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector2d;
using sketch::curve_jet;

constexpr double visible = 20.0;  // mm

using Net = std::vector<Vector2d>;

Net projected(model::View view, const model::Curve& curve) {
  Net net;
  for (const auto& point : curve.points) net.push_back(model::project(view, point));
  return net;
}

Vector2d at(const Net& net, double t) { return curve_jet<2>(net, t).point; }

// Parameters at even distances along a plane curve.
std::vector<double> even_lengths(const Net& net, double from, double to, int count) {
  constexpr int fine = 4000;
  std::vector<double> passed{0.0};
  const auto parameter = [&](int k) { return from + (to - from) * k / fine; };
  for (int k = 1; k <= fine; ++k)
    passed.push_back(passed.back() + (at(net, parameter(k)) - at(net, parameter(k - 1))).norm());
  std::vector<double> parameters;
  for (int k = 0; k < count; ++k) {
    const double wanted = passed.back() * k / (count - 1);
    const auto next = std::lower_bound(passed.begin(), passed.end(), wanted);
    parameters.push_back(parameter(int(next - passed.begin())));
  }
  return parameters;
}

model::DrawnPath polyline(const std::vector<Vector2d>& points) {
  model::DrawnPath path;
  for (std::size_t k = 1; k < points.size(); ++k)
    path.segments.push_back(model::line_segment(points[k - 1], points[k]));
  return path;
}

// Cubic pieces with the curve's points and derivatives at even parameters: one when it is a cubic.
model::DrawnPath pieces(const Net& net, double from, double to) {
  const int count = net.size() > 4 ? 4 : 1;
  model::DrawnPath path;
  for (int k = 0; k < count; ++k) {
    const double step = (to - from) / count, begin = from + k * step;
    const auto a = curve_jet<2>(net, begin), b = curve_jet<2>(net, begin + step);
    path.segments.push_back(
        {{a.point, a.point + a.first * step / 3.0, b.point - b.first * step / 3.0, b.point}});
  }
  return path;
}

}  // namespace

std::vector<model::PlacedDrawing> drawn_curves(const model::Model& model,
                                               const DrawOptions& options) {
  std::mt19937 engine(options.seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::uniform_real_distribution<double> ends(-options.ends, options.ends);
  std::vector<model::PlacedDrawing> drawings;
  for (const model::View view : options.views) {
    drawings.push_back({view, {}});
    for (const model::Curve& curve : model.curves) {
      const Net net = projected(view, curve);
      const double from = ends(engine), to = 1.0 + ends(engine);
      const auto shake = [&](Vector2d& point) {
        point += options.noise * Vector2d(noise(engine), noise(engine));
      };
      model::DrawnPath path;
      if (options.hand == Hand::bezier) {
        path = pieces(net, from, to);
        for (std::size_t k = 0; k < path.segments.size(); ++k) {
          for (int i = 0; i < 4; ++i) shake(path.segments[k].points[i]);
          if (k > 0) path.segments[k].points[0] = path.segments[k - 1].points[3];
        }
      } else {
        std::vector<double> parameters = even_lengths(net, from, to, options.points);
        if (options.hand == Hand::even_parameters)
          for (int k = 0; k < options.points; ++k)
            parameters[k] = from + (to - from) * k / (options.points - 1);
        std::vector<Vector2d> points;
        for (const double t : parameters) shake(points.emplace_back(at(net, t)));
        path = polyline(points);
      }
      path.name = curve.name;
      if (model::drawn_box({&path, 1}).sizes().norm() < visible) continue;
      drawings.back().paths.push_back(std::move(path));
    }
  }
  return drawings;
}

double largest_move(const model::Curve& a, const model::Curve& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.points.size(); ++k)
    largest = std::max(largest, (a.points[k] - b.points[k]).norm());
  return largest;
}

}  // namespace bodyline::testing
