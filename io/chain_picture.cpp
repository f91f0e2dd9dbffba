#include "io/chain_picture.hpp"

#include <fmt/format.h>

#include "io/svg_color.hpp"
#include "model/bernstein.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector3d;

constexpr double margin = 24.0;  // pixels
constexpr int steps = 24;        // straight pieces of a Bezier piece
constexpr double tolerance_of_size = 1e-4;

std::vector<Vector3d> all_points(const model::CurveChain& chain) {
  std::vector<Vector3d> points;
  for (const model::FamilyCurve& curve : chain.curves)
    points.insert(points.end(), curve.points.begin(), curve.points.end());
  return points;
}

std::string polyline(const Camera& camera, const std::vector<Vector3d>& points,
                     const std::string& style) {
  std::string text = "<polyline fill=\"none\" " + style + " points=\"";
  for (const Vector3d& point : points) {
    const Eigen::Vector2d at = camera.project(point);
    text += fmt::format("{:.2f},{:.2f} ", at.x(), at.y());
  }
  text.back() = '"';
  return text + "/>\n";
}

std::vector<Vector3d> sampled(const model::FamilyCurve& curve, double tolerance_mm) {
  std::vector<Vector3d> points;
  for (const std::vector<Vector3d>& piece : model::bezier_pieces(curve, tolerance_mm)) {
    const int degree = int(piece.size()) - 1;
    for (int k = points.empty() ? 0 : 1; k <= steps; ++k) {
      const model::BernsteinJet jet = model::bernstein(degree, double(k) / steps);
      Vector3d& point = points.emplace_back(Vector3d::Zero());
      for (int i = 0; i <= degree; ++i) point += jet.d[0][i] * piece[i];
    }
  }
  return points;
}

}  // namespace

std::string chain_svg(const model::CurveChain& chain, const View& view, int width, int height) {
  const std::vector<Vector3d> points = all_points(chain);
  View parallel = view;
  parallel.perspective = false;
  const Camera camera(parallel, points, {margin, margin, width - margin, height - margin});
  Vector3d low = points.front(), high = low;
  for (const Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double tolerance_mm = std::max(tolerance_of_size * (high - low).norm(), 1e-9);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
      "height=\"{}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height, width, height);
  for (const model::FamilyCurve& curve : chain.curves)
    svg += polyline(camera, curve.points, "stroke=\"#b8b8b8\" stroke-width=\"1\"");
  for (std::size_t k = 0; k < chain.curves.size(); ++k) {
    const Color color = categorical_color(int(k), int(chain.curves.size()));
    svg += polyline(
        camera, sampled(chain.curves[k], tolerance_mm),
        "stroke=\"" + svg_color(0.6f * color) + "\" stroke-width=\"3\" stroke-linecap=\"round\"");
  }
  for (const model::FamilyCurve& curve : chain.curves) {
    const Eigen::Vector2d at = camera.project(curve.points.front());
    svg += fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"white\" "
        "stroke=\"black\"/>\n",
        at.x(), at.y());
  }
  return svg + "</svg>\n";
}

}  // namespace bodyline::io
