#include "io/read_scan_assimp.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <utility>

#include "io/check_gltf.hpp"
#include "io/scan_collector.hpp"
#include "io/scan_input.hpp"
#include "io/scan_mesh.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

// assimp holds a file several times over in memory.
constexpr std::uint64_t largest_file = std::uint64_t{512} << 20;

std::string format_name(const std::filesystem::path& path) {
  return lower_extension(path) == ".obj" ? "OBJ" : "glTF";
}

Eigen::Vector3d vector_from(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// A mesh of the file and where the file puts it.
using PlacedMesh = std::pair<const aiMesh*, aiMatrix4x4>;

// Every mesh as often as it is used.
std::vector<PlacedMesh> placed_meshes(const aiScene& scene) {
  std::vector<PlacedMesh> meshes;
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> waiting{{scene.mRootNode, aiMatrix4x4()}};
  while (!waiting.empty()) {
    const auto [node, parent] = waiting.back();
    waiting.pop_back();
    const aiMatrix4x4 placed = parent * node->mTransformation;
    for (unsigned k = 0; k < node->mNumMeshes; ++k) {
      meshes.emplace_back(scene.mMeshes[node->mMeshes[k]], placed);
    }
    for (unsigned k = node->mNumChildren; k > 0; --k) {
      waiting.emplace_back(node->mChildren[k - 1], placed);
    }
  }
  return meshes;
}

bool has_faces(const PlacedMesh& mesh) {
  constexpr unsigned faces = aiPrimitiveType_TRIANGLE | aiPrimitiveType_POLYGON;
  return (mesh.first->mPrimitiveTypes & faces) != 0 && mesh.first->mNumFaces > 0;
}

// assimp does not check the indices of all formats.
std::uint32_t vertex_index(const ScanInput& input, const aiMesh& part, unsigned index) {
  if (index < part.mNumVertices) return index;
  input.fail(fmt::format("a face uses vertex {}, but there are {}, counted from 0.", index,
                         part.mNumVertices));
}

void append_mesh(const ScanInput& input, const PlacedMesh& placed, ScanMesh& mesh) {
  const auto& [part, transformation] = placed;
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (unsigned k = 0; k < part->mNumVertices; ++k) {
    mesh.points.push_back(vector_from(transformation * part->mVertices[k]));
  }
  // A transformation with a reflection turns faces inside out.
  const bool reflects = aiMatrix3x3(transformation).Determinant() < 0;
  std::vector<std::uint32_t> polygon;
  bool fits = mesh.points.size() <= 3 * most_triangles;
  for (unsigned k = 0; fits && k < part->mNumFaces; ++k) {
    const aiFace& face = part->mFaces[k];
    polygon.clear();
    for (unsigned corner = 0; corner < face.mNumIndices; ++corner) {
      polygon.push_back(first + vertex_index(input, *part, face.mIndices[corner]));
    }
    if (reflects) std::reverse(polygon.begin(), polygon.end());
    fits = append_polygon(mesh, polygon);
  }
  if (!fits) input.fail(fmt::format("has more than {} triangles.", most_triangles));
}

void append_points(const PlacedMesh& placed, ScanCollector& collector) {
  const auto& [part, transformation] = placed;
  const aiMatrix3x3 turn(transformation);
  for (unsigned k = 0; k < part->mNumVertices; ++k) {
    collector.add(vector_from(transformation * part->mVertices[k]),
                  part->HasNormals() ? vector_from(turn * part->mNormals[k])
                                     : Eigen::Vector3d(Eigen::Vector3d::Zero()));
  }
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~') c = ' ';
  }
  return text;
}

// No post-processing: assimp as Debian builds it ends the program where its triangulation of a
// damaged file goes wrong.
const aiScene& imported(Assimp::Importer& importer, const ScanInput& input) {
  const aiScene* const scene = importer.ReadFile(input.path().string(), 0);
  if (scene != nullptr && scene->mRootNode != nullptr) return *scene;
  input.fail(fmt::format("cannot be read as {}: {}", format_name(input.path()),
                         one_line(importer.GetErrorString())));
}

}  // namespace

ScanFile read_scan_assimp(const std::filesystem::path& path, const ReadScanOptions& options) {
  const ScanInput input(path);
  if (input.size() > largest_file) input.fail("is larger than 512 MiB; save it as PLY.");
  if (lower_extension(path) != ".obj") check_gltf(path);
  Assimp::Importer importer;
  const std::vector<PlacedMesh> meshes = placed_meshes(imported(importer, input));
  ScanMesh mesh;
  for (const PlacedMesh& placed : meshes) {
    if (has_faces(placed)) append_mesh(input, placed, mesh);
  }
  if (!mesh.triangles.empty()) {
    return scan_from_mesh(path, mesh, options, format_name(path));
  }
  ScanCollector collector(options);
  for (const PlacedMesh& placed : meshes) append_points(placed, collector);
  return collector.finish(format_name(path));
}

}  // namespace bodyline::io
