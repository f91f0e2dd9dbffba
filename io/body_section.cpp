#include "io/body_section.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "io/tessellate.hpp"

namespace bodyline::io {
namespace {

constexpr int cells_per_face = 48;
constexpr std::string_view axes = "xyz";

// A triangle has no corner on the plane: one that lies there counts as beyond it.
void cut_triangle(const std::array<Eigen::Vector3d, 3>& corners, const SectionPlane& plane,
                  std::vector<Segment>& segments) {
  Segment segment;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d &a = corners[k], &b = corners[(k + 1) % 3];
    const double to_a = a[plane.axis] - plane.at, to_b = b[plane.axis] - plane.at;
    if ((to_a < 0.0) == (to_b < 0.0)) continue;
    segment[std::size_t(count++)] = a + to_a / (to_a - to_b) * (b - a);
  }
  if (count == 2) segments.push_back(segment);
}

}  // namespace

std::string SectionPlane::name() const {
  return fmt::format("{} = {:.0f} mm", axes[std::size_t(axis)], at);
}

SectionPlane section_plane_from_text(const std::string& text) {
  const std::size_t axis = text.empty() ? axes.npos : axes.find(text[0]);
  SectionPlane plane;
  if (axis != axes.npos && text.size() > 2 && text[1] == '=') {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 2, end, plane.at);
    plane.axis = int(axis);
    if (error == std::errc{} && stop == end && std::isfinite(plane.at)) return plane;
  }
  throw std::invalid_argument("'" + text + "' is not a plane: give x=, y= or z= and mm");
}

std::vector<SectionPlane> usual_section_planes(const std::vector<model::Surface>& faces) {
  Eigen::AlignedBox3d box;
  for (const model::Surface& face : faces) {
    for (const Eigen::Vector3d& point : face.net) box.extend(point);
  }
  std::vector<SectionPlane> planes{{1, 0.0}};
  for (const double share : {0.2, 0.5, 0.8}) {
    planes.push_back({0, std::round(box.min().x() + share * box.sizes().x())});
  }
  return planes;
}

std::vector<Segment> body_section(const std::vector<model::Surface>& faces,
                                  const SectionPlane& plane) {
  std::vector<Segment> segments;
  for (const FaceGrid& grid : tessellate(faces, cells_per_face)) {
    for (int i = 0; i < grid.cells; ++i) {
      for (int j = 0; j < grid.cells; ++j) {
        const Eigen::Vector3d &a = grid.point(i, j), &b = grid.point(i + 1, j),
                              &c = grid.point(i, j + 1), &d = grid.point(i + 1, j + 1);
        cut_triangle({a, b, c}, plane, segments);
        cut_triangle({c, b, d}, plane, segments);
      }
    }
  }
  return segments;
}

}  // namespace bodyline::io
