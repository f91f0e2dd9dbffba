#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::io {

/// A plane x, y or z = at.
struct SectionPlane {
  int axis = 1;     ///< 0, 1 or 2
  double at = 0.0;  ///< mm

  std::string name() const;  ///< for example "x = 1200 mm"
};

/// Reads "x=1200". Throws std::invalid_argument for anything else.
SectionPlane section_plane_from_text(const std::string& text);

/// y = 0, and x at 20, 50 and 80 % of the body's length.
std::vector<SectionPlane> usual_section_planes(const std::vector<model::Surface>& faces);

using Segment = std::array<Eigen::Vector3d, 2>;

/// Where a plane cuts the faces: chords of at most a few mm error, in no order.
std::vector<Segment> body_section(const std::vector<model::Surface>& faces,
                                  const SectionPlane& plane);

}  // namespace bodyline::io
