#pragma once

#include <string>
#include <vector>

#include "model/face_net.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// Faces of a body as a net: sides that are the same curve become one edge (match_sides), sides
/// that are points none.
model::FaceNet body_net(const std::vector<model::Surface>& faces, const std::string& name);

}  // namespace bodyline::io
