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
constexpr int teeth = 24;  // of the comb of a curve
constexpr double comb_radius_mm = 100.0;

std::vector<Vector3d> all_points(const model::CurveChain& chain) {
  std::vector<Vector3d> points;
  for (const model::FamilyCurve& curve : chain.curves)
    points.insert(points.end(), curve.points.begin(), curve.points.end());
  return points;
}

// A comb's tooth, from the curve against the curvature vector.
struct Tooth {
  Vector3d foot, tip;
};

std::vector<Tooth> comb(const model::FamilyCurve& curve, double comb_mm) {
  std::vector<Tooth> comb;
  for (int k = 0; k <= teeth; ++k) {
    const model::CurveJet jet = model::jet(curve, double(k) / teeth);
    const double speed2 = jet.d[1].squaredNorm();
    if (speed2 == 0.0) continue;
    const Vector3d curvature = (jet.d[2] - (jet.d[2].dot(jet.d[1]) / speed2) * jet.d[1]) / speed2;
    comb.push_back({jet.d[0], jet.d[0] - comb_mm * comb_radius_mm * curvature});
  }
  return comb;
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

std::string comb_lines(const Camera& camera, const std::vector<Tooth>& comb) {
  const std::string style = "stroke=\"#a05050\" stroke-width=\"0.8\"";
  std::string svg;
  std::vector<Vector3d> tips;
  for (const Tooth& tooth : comb) {
    svg += polyline(camera, {tooth.foot, tooth.tip}, style);
    tips.push_back(tooth.tip);
  }
  return tips.empty() ? svg : svg + polyline(camera, tips, style);
}

double size_of(const std::vector<Vector3d>& points) {
  Vector3d low = points.front(), high = low;
  for (const Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).norm();
}

}  // namespace

std::string chain_svg(const model::CurveChain& chain, const ChainDrawing& drawing) {
  std::vector<Vector3d> shown = all_points(chain);
  const double tolerance_mm = std::max(tolerance_of_size * size_of(shown), 1e-9);
  std::vector<std::vector<Tooth>> combs;
  for (const model::FamilyCurve& curve : chain.curves) {
    if (drawing.comb_mm == 0.0) continue;
    for (const Tooth& tooth : combs.emplace_back(comb(curve, drawing.comb_mm)))
      shown.push_back(tooth.tip);
  }
  View parallel = drawing.view;
  parallel.perspective = false;
  const Camera camera(parallel, shown,
                      {margin, margin, drawing.width - margin, drawing.height - margin});
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
      "height=\"{}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      drawing.width, drawing.height, drawing.width, drawing.height);
  for (const auto& comb : combs) svg += comb_lines(camera, comb);
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
