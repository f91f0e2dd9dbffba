#pragma once

#include "model/face_net.hpp"
#include "strokes/refine_patch.hpp"

namespace bodyline::strokes {

/// The net of a body with one face replaced by the net of its refinement: faces that met the face's
/// sides meet the outer edges of that instead. The new faces are called as the face, with a number.
/// Throws std::invalid_argument for a face that has not exactly one edge along each side.
model::FaceNet refined_body(const model::FaceNet& body, int face, const Net& refinement);

/// The same for the mirror image of the face that was refined.
model::FaceNet refined_mirror_image(const model::FaceNet& body, int face, const Net& refinement);

}  // namespace bodyline::strokes
