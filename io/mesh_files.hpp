#pragma once

#include <string>

#include "io/mesh.hpp"

namespace bodyline::io {

/// Binary STL, mm, with the triangles' own normals. The format knows neither shared vertices nor
/// names.
std::string stl_file(const Mesh& mesh);

/// Wavefront OBJ, mm: shared vertices, exact vertex normals, one group per face.
std::string obj_file(const Mesh& mesh);

/// Binary PLY (little endian), mm: shared vertices with normals; the faces' names and triangle
/// ranges are comments. Where faces meet at an angle a vertex has the mean of their normals.
std::string ply_file(const Mesh& mesh);

/// glTF 2.0 as one binary file (.glb): one node and mesh per face, named, each with its own copy of
/// the vertices it uses (bit for bit the neighbour's). Vertices are in mm, z up; the root node
/// turns them to metres, y up.
std::string glb_file(const Mesh& mesh);

/// The same as JSON text with the buffer embedded (.gltf).
std::string gltf_file(const Mesh& mesh);

}  // namespace bodyline::io
