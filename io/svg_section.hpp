#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/body_section.hpp"

namespace bodyline::io {

/// A point of a scan with its signed distance from the body, mm.
struct MeasuredPoint {
  Eigen::Vector3d point;
  double distance = 0.0;
};

/// A section of the left half of a body with points of a scan near the plane, as an inline SVG to
/// scale: the body a line, the points dots whose colour tells their distance (deep beyond half the
/// range, grey within a quarter). At most some thousand points are drawn, taken evenly. Empty when
/// the plane misses the body.
std::string svg_section(const std::vector<model::Surface>& faces, const SectionPlane& plane,
                        const std::vector<MeasuredPoint>& points, double range);

}  // namespace bodyline::io
