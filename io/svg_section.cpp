#include "io/svg_section.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "io/palette.hpp"
#include "io/report_html.hpp"
#include "io/svg_color.hpp"

namespace bodyline::io {
namespace {

constexpr double slab = 8.0;  // mm to both sides of the plane
constexpr std::size_t most_points = 4000;
constexpr double margin = 60.0;  // mm around the body

// Steps of the points' colours, from far inside to far outside.
constexpr std::array<double, 5> steps{-1.0, -0.55, 0.0, 0.55, 1.0};

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

std::string step_color(double step) {
  return svg_color(step == 0.0 ? color_from_srgb(120, 128, 138) : diverging_color(step));
}

int step_of(double distance, double range) {
  const double t = distance / range;
  return std::abs(t) <= 0.25 ? 2 : t < 0.0 ? (t < -0.5 ? 0 : 1) : (t > 0.5 ? 4 : 3);
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

// One path per colour; a dot is a line without length.
std::string point_paths(const std::vector<MeasuredPoint>& points, const SectionPlane& plane,
                        double range, const Eigen::AlignedBox2d& box) {
  std::vector<const MeasuredPoint*> near;
  for (const MeasuredPoint& point : points) {
    const bool in_slab = std::abs(point.point[plane.axis] - plane.at) <= slab;
    if (in_slab && box.contains(in_picture(point.point, plane.axis))) near.push_back(&point);
  }
  std::array<std::string, steps.size()> paths;
  const std::size_t count = std::min(near.size(), most_points);
  for (std::size_t k = 0; k < count; ++k) {
    const MeasuredPoint& point = *near[k * near.size() / count];
    const Eigen::Vector2d at = in_picture(point.point, plane.axis);
    paths[std::size_t(step_of(point.distance, range))] +=
        fmt::format("M{:.1f} {:.1f}h0", at.x(), at.y());
  }
  std::string svg;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (paths[k].empty()) continue;
    svg += fmt::format("<path class=\"dots\" stroke=\"{}\" d=\"{}\"/>\n", step_color(steps[k]),
                       paths[k]);
  }
  return svg;
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
         point_paths(points, plane, range, box) +
         fmt::format("<path class=\"cut\" d=\"{}\"/>\n</svg>\n", body);
}

}  // namespace bodyline::io
