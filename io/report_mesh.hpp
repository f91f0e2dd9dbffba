#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::io {

/// Two bodies with the same faces, sampled for drawing in a browser. Every face is a grid of
/// (cells + 1)^2 vertices, v fastest; a vertex is eight 16-bit integers, little-endian:
/// x, y, z, curvature, normal x, y, z, 0, each a fraction of 32767. Positions are around a common
/// centre with a common scale, so that the two bodies can be blended.
struct ReportMesh {
  int cells = 0;
  std::vector<bool> mirrored;  ///< by face: to be drawn a second time with y turned over
  std::vector<std::uint8_t> before, after;
};

/// Samples the faces of the left half and the middle. `curvature_range` (1/m) is the mean curvature
/// at which the fraction becomes 1. Empty (no cells) when the bodies differ in their faces.
ReportMesh report_mesh(const std::vector<model::Surface>& before,
                       const std::vector<model::Surface>& after, double curvature_range);

}  // namespace bodyline::io
