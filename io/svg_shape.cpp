#include "io/svg_shape.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>
#include <string>

#include "io/drawing_limits.hpp"
#include "io/svg_arc.hpp"
#include "io/svg_length.hpp"
#include "io/svg_path.hpp"
#include "io/svg_scanner.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using Paths = std::vector<model::DrawnPath>;

std::string_view text_of(const pugi::xml_node& element, const char* attribute) {
  return element.attribute(attribute).value();
}

double length_of(const pugi::xml_node& element, const char* attribute, double otherwise = 0.0) {
  const std::string_view text = text_of(element, attribute);
  return text.empty() || text == "auto" ? otherwise : svg_length(text).pixels;
}

void append_line(model::DrawnPath& path, const Vector2d& from, const Vector2d& to) {
  if (from != to) path.segments.push_back(model::line_segment(from, to));
}

Paths one(model::DrawnPath path) {
  if (path.segments.empty()) return {};
  return {std::move(path)};
}

Paths line(const pugi::xml_node& element) {
  model::DrawnPath path;
  append_line(path, {length_of(element, "x1"), length_of(element, "y1")},
              {length_of(element, "x2"), length_of(element, "y2")});
  return one(std::move(path));
}

Paths polyline(const pugi::xml_node& element, bool closed) {
  SvgScanner scanner(text_of(element, "points"));
  std::vector<Vector2d> points;
  while (!scanner.at_end()) {
    const double x = scanner.number();
    scanner.skip_separator();
    points.emplace_back(x, scanner.number());
    scanner.skip_separator();
    if (points.size() > most_drawn_segments) throw std::invalid_argument("it has too many points");
  }
  model::DrawnPath path;
  for (std::size_t k = 1; k < points.size(); ++k) append_line(path, points[k - 1], points[k]);
  if (closed && !points.empty()) append_line(path, points.back(), points.front());
  path.closed = closed;
  return one(std::move(path));
}

Paths ellipse(const pugi::xml_node& element, double radius_x, double radius_y) {
  if (!(radius_x > 0.0 && radius_y > 0.0)) return {};
  model::DrawnPath path;
  path.segments =
      elliptic_arc({length_of(element, "cx"), length_of(element, "cy")},
                   Vector2d(radius_x, radius_y).asDiagonal(), 0.0, 2.0 * std::numbers::pi);
  path.segments.back().points.back() = path.segments.front().points.front();
  path.closed = true;
  return one(std::move(path));
}

Paths rectangle(const pugi::xml_node& element) {
  const Vector2d lower(length_of(element, "x"), length_of(element, "y"));
  const Vector2d size(length_of(element, "width"), length_of(element, "height"));
  if (!(size.minCoeff() > 0.0)) return {};
  double radius_x = length_of(element, "rx", -1.0), radius_y = length_of(element, "ry", -1.0);
  if (radius_x < 0.0) radius_x = radius_y;
  if (radius_y < 0.0) radius_y = radius_x;
  const Vector2d radii = Vector2d(radius_x, radius_y).cwiseMax(0.0).cwiseMin(size / 2.0);
  model::DrawnPath path;
  path.closed = true;
  // From the top middle of a picture clockwise: an edge, then the corner behind it.
  const std::array<Vector2d, 4> corners{Vector2d(1, 0), Vector2d(1, 1), Vector2d(0, 1),
                                        Vector2d(0, 0)};
  Vector2d at = lower + Vector2d(radii.x(), 0.0);
  for (int k = 0; k < 4; ++k) {
    const Vector2d corner = lower + corners[k].cwiseProduct(size);
    const Vector2d inwards = (Vector2d(1, 1) - 2.0 * corners[k]).cwiseProduct(radii);
    const bool vertical_next = k % 2 == 0;
    const Vector2d before =
        corner + (vertical_next ? Vector2d(inwards.x(), 0.0) : Vector2d(0.0, inwards.y()));
    const Vector2d behind =
        corner + (vertical_next ? Vector2d(0.0, inwards.y()) : Vector2d(inwards.x(), 0.0));
    append_line(path, at, before);
    for (const auto& segment : svg_arc(before, {radii, 0.0, false, true}, behind))
      path.segments.push_back(segment);
    at = behind;
  }
  path.segments.back().points.back() = path.segments.front().points.front();
  return one(std::move(path));
}

}  // namespace

bool is_svg_shape(std::string_view name) {
  constexpr std::array<std::string_view, 7> names{"path", "line",   "polyline", "polygon",
                                                  "rect", "circle", "ellipse"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

Paths svg_shape(const pugi::xml_node& element, std::string_view name) {
  if (name == "path") return svg_path(text_of(element, "d"));
  if (name == "line") return line(element);
  if (name == "polyline" || name == "polygon") return polyline(element, name == "polygon");
  if (name == "rect") return rectangle(element);
  const double radius = length_of(element, "r");
  if (name == "circle") return ellipse(element, radius, radius);
  return ellipse(element, length_of(element, "rx"), length_of(element, "ry"));
}

}  // namespace bodyline::io
