#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/surface_field.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// Two bodies with the same faces, sampled for drawing in a browser. Every face is a grid of
/// (cells + 1)^2 vertices, v fastest; a vertex is eight 16-bit integers, little-endian:
/// x, y, z, value, normal x, y, z, known, each a fraction of 32767. Positions are around a common
/// centre with a common scale, so that the two bodies can be blended. What the value is, the caller
/// says; `known` is 0 where there is none, else 1.
struct ReportMesh {
  int cells = 0;
  std::vector<bool> mirrored;  ///< by face: to be drawn a second time with y turned over
  std::vector<std::uint8_t> before, after;
};

/// A number at a point of a face, 1 where the colours end; NaN where nothing is known.
using ReportValue = std::function<double(const model::Surface& face, double u, double v)>;

/// Mean curvature over its range, 1/m.
ReportValue curvature_value(double range);

/// A field over its range. `field` must outlive the value.
ReportValue field_value(const SurfaceField& field);

/// Samples the faces of the left half and the middle. Empty (no cells) when the bodies differ in
/// their faces.
ReportMesh report_mesh(const std::vector<model::Surface>& before,
                       const std::vector<model::Surface>& after, const ReportValue& value);

}  // namespace bodyline::io
