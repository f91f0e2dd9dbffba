#pragma once

#include <string>
#include <vector>

#include "model/check_face_net.hpp"
#include "model/model.hpp"
#include "model/stroke.hpp"
#include "strokes/build_surface.hpp"

namespace bodyline::cli {

/// A body with one of its patches refined by strokes, and its mirror image with it; it stays
/// symmetric unless a stroke crosses the middle and is not symmetric itself.
struct RefinedModel {
  strokes::SurfaceBuild build;
  model::FaceNet net;              ///< the whole body
  model::FaceNetCheck check;       ///< of it, but only where the refined faces are part of it
  double border_deg = 0.0;         ///< largest angle between them and their neighbours, ...
  double border_before_deg = 0.0;  ///< ... and between the patch and those before
};

/// Refines the kept patch `patch` of a model's body, left or central; a central one by the strokes
/// with their mirror images (strokes::symmetric_strokes). Throws std::invalid_argument when there
/// is no such patch, for one of the right half, and as strokes::refine_patch.
RefinedModel refine_model(const model::Model& model, const std::string& patch,
                          const std::vector<model::Stroke>& strokes,
                          const strokes::BuildOptions& options);

}  // namespace bodyline::cli
