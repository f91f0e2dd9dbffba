#pragma once

#include <string>
#include <vector>

#include "model/face_net.hpp"
#include "strokes/net.hpp"

namespace bodyline::strokes {

/// The patches of a net as faces that share edges, exactly. Faces are called "patch 1", "patch 2",
/// and so on.
model::FaceNet face_net(const Net& net, const std::string& name);

}  // namespace bodyline::strokes
