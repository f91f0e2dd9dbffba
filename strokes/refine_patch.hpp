#pragma once

#include "model/surface.hpp"
#include "strokes/build_surface.hpp"

namespace bodyline::strokes {

/// Refines a polynomial face by strokes: it is the base, over the unit square of its parameters,
/// with its sides as the boundary. The surface keeps the face's border with its tangent planes
/// exactly, and the face where strokes ask for nothing else. Throws std::invalid_argument for a
/// face with a side that is a point, and for the paper's method, which would not keep the border's
/// planes.
SurfaceBuild refine_patch(const model::Surface& face, const std::vector<model::Stroke>& strokes,
                          const BuildOptions& options = {});

/// A part of a side of a refined face.
struct BorderPart {
  int edge = -1;  ///< of the net
  model::Side side = model::Side::u0;
  bool reversed = false;        ///< the edge runs against the side's running parameter
  double from = 0.0, to = 1.0;  ///< of that
};

/// The outer edges of the net of a refined face.
std::vector<BorderPart> border_parts(const Net& net);

}  // namespace bodyline::strokes
