#include "io/svg_outline.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "io/report_html.hpp"
#include "io/svg_dots.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;

constexpr double margin = 60.0;  // mm

Vector2d y_down(const Vector2d& point) { return {point.x(), -point.y()}; }

}  // namespace

std::string svg_outline(const std::string& view, const std::vector<std::vector<Vector2d>>& lines,
                        const std::vector<Vector2d>& points, const std::vector<double>& distances,
                        double range) {
  Eigen::AlignedBox2d box;
  std::string path;
  for (const std::vector<Vector2d>& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Vector2d at = y_down(line[k]);
      box.extend(at);
      path += fmt::format("{}{:.1f} {:.1f}", k == 0 ? "M" : "L", at.x(), at.y());
    }
  }
  std::vector<SvgDot> dots;
  for (std::size_t k = 0; k < points.size(); ++k) {
    dots.push_back({y_down(points[k]), distances[k]});
    box.extend(dots.back().at);
  }
  if (box.isEmpty()) return "";
  box.min().array() -= margin;
  box.max().array() += margin;
  return fmt::format(
             "<svg class=\"section\" role=\"img\" aria-label=\"Outline from {}\" "
             "viewBox=\"{:.0f} {:.0f} {:.0f} {:.0f}\">\n",
             html_escaped(view), box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y()) +
         svg_dots(dots, range) + fmt::format("<path class=\"cut\" d=\"{}\"/>\n</svg>\n", path);
}

}  // namespace bodyline::io
