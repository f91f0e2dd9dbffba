#include "io/svg_section.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "io/report_html.hpp"
#include "io/svg_dots.hpp"

namespace bodyline::io {
namespace {

constexpr double slab = 8.0;  // mm to both sides of the plane
constexpr std::size_t most_points = 4000;
constexpr double margin = 60.0;  // mm around the body

// Right and down in the picture, as seen from behind, from the left side and from above; in the
// latter two the front of the car is at the left.
Eigen::Vector2d in_picture(const Eigen::Vector3d& point, int axis) {
  switch (axis) {
    case 0:
      return {point.y(), -point.z()};
    case 1:
      return {point.x(), -point.z()};
    default:
      return {point.x(), -point.y()};
  }
}

// Of the left half, unless the plane lies along the car.
std::string body_path(const std::vector<Segment>& segments, int axis, Eigen::AlignedBox2d& box) {
  std::string path;
  for (const Segment& segment : segments) {
    if (axis != 1 && segment[0].y() + segment[1].y() > 0.0) continue;
    const Eigen::Vector2d a = in_picture(segment[0], axis), b = in_picture(segment[1], axis);
    box.extend(a);
    box.extend(b);
    path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", a.x(), a.y(), b.x(), b.y());
  }
  return path;
}

// Those near the plane and within the picture, some of them where there are many.
std::vector<SvgDot> dots_of(const std::vector<MeasuredPoint>& points, const SectionPlane& plane,
                            const Eigen::AlignedBox2d& box) {
  std::vector<SvgDot> near;
  for (const MeasuredPoint& point : points) {
    const Eigen::Vector2d at = in_picture(point.point, plane.axis);
    const bool in_slab = std::abs(point.point[plane.axis] - plane.at) <= slab;
    if (in_slab && box.contains(at)) near.push_back({at, point.distance});
  }
  const std::size_t count = std::min(near.size(), most_points);
  std::vector<SvgDot> dots;
  for (std::size_t k = 0; k < count; ++k) dots.push_back(near[k * near.size() / count]);
  return dots;
}

}  // namespace

std::string svg_section(const std::vector<model::Surface>& faces, const SectionPlane& plane,
                        const std::vector<MeasuredPoint>& points, double range) {
  const std::vector<Segment> segments = body_section(faces, plane);
  Eigen::AlignedBox2d box;
  const std::string body = body_path(segments, plane.axis, box);
  if (body.empty()) return "";
  box.min().array() -= margin;
  box.max().array() += margin;
  const Eigen::Vector2d size = box.sizes();
  return fmt::format(
             "<svg class=\"section\" role=\"img\" aria-label=\"Section at {}\" viewBox=\"{:.0f} "
             "{:.0f} {:.0f} {:.0f}\">\n",
             html_escaped(plane.name()), box.min().x(), box.min().y(), size.x(), size.y()) +
         svg_dots(dots_of(points, plane, box), range) +
         fmt::format("<path class=\"cut\" d=\"{}\"/>\n</svg>\n", body);
}

}  // namespace bodyline::io
