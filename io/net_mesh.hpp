#pragma once

#include "io/mesh.hpp"
#include "model/face_net.hpp"

namespace bodyline::io {

/// Meshes the faces of a net. Along every edge of the net all faces use the same points, so that
/// the mesh is closed but for the outer boundary, also where a side of one face is several edges of
/// others. Throws as make_mesh for surfaces does.
Mesh make_mesh(const model::FaceNet& net, const MeshOptions& options = {});

}  // namespace bodyline::io
