#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/mesh_files.hpp"

namespace bodyline::io {
namespace {

using Json = nlohmann::ordered_json;

// Constants of the glTF 2.0 specification.
constexpr int type_uint32 = 5125, type_float = 5126;
constexpr int target_vertices = 34962, target_indices = 34963;
constexpr int mode_triangles = 4;
constexpr std::uint32_t magic_gltf = 0x46546C67, chunk_json = 0x4E4F534A, chunk_binary = 0x004E4942;

/// The document and its one buffer, which grows face by face.
struct Document {
  Json json;
  std::string buffer;
};

void append(std::string& text, std::uint32_t value) {
  text.append(reinterpret_cast<const char*>(&value), 4);
}

/// Adds a view of the last `bytes` bytes of the buffer; returns its number.
std::size_t add_view(Document& document, std::size_t bytes, int target) {
  document.json["bufferViews"].push_back({{"buffer", 0},
                                          {"byteOffset", document.buffer.size() - bytes},
                                          {"byteLength", bytes},
                                          {"target", target}});
  return document.json["bufferViews"].size() - 1;
}

std::size_t add_accessor(Document& document, Json accessor) {
  document.json["accessors"].push_back(std::move(accessor));
  return document.json["accessors"].size() - 1;
}

std::size_t add_vectors(Document& document, const std::vector<Eigen::Vector3f>& vectors,
                        bool with_bounds) {
  Eigen::Vector3f low = vectors.front(), high = vectors.front();
  for (const Eigen::Vector3f& v : vectors) {
    document.buffer.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(float));
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const std::size_t view = add_view(document, vectors.size() * 3 * sizeof(float), target_vertices);
  Json accessor{{"bufferView", view},
                {"componentType", type_float},
                {"count", vectors.size()},
                {"type", "VEC3"}};
  if (with_bounds) {
    accessor["min"] = {low[0], low[1], low[2]};
    accessor["max"] = {high[0], high[1], high[2]};
  }
  return add_accessor(document, std::move(accessor));
}

std::size_t add_indices(Document& document, const std::vector<std::uint32_t>& indices) {
  for (std::uint32_t index : indices) append(document.buffer, index);
  const std::size_t view = add_view(document, indices.size() * 4, target_indices);
  return add_accessor(document, {{"bufferView", view},
                                 {"componentType", type_uint32},
                                 {"count", indices.size()},
                                 {"type", "SCALAR"}});
}

/// Adds one face as a mesh and a node; returns the node.
std::size_t add_part(Document& document, const Mesh& mesh, const MeshPart& part) {
  std::map<std::pair<int, int>, std::uint32_t> numbers;
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<std::uint32_t> indices;
  for (int t = part.first_triangle; t < part.first_triangle + part.triangles; ++t) {
    for (int k = 0; k < 3; ++k) {
      const int point = mesh.triangles[t][k], normal = mesh.triangle_normals[t][k];
      const auto [at, is_new] =
          numbers.try_emplace({point, normal}, static_cast<std::uint32_t>(points.size()));
      if (is_new) {
        points.push_back(mesh.points[point]);
        normals.push_back(mesh.normals[normal].normalized());
      }
      indices.push_back(at->second);
    }
  }
  const std::size_t position = add_vectors(document, points, true);
  const std::size_t direction = add_vectors(document, normals, false);
  const Json primitive{{"attributes", {{"POSITION", position}, {"NORMAL", direction}}},
                       {"indices", add_indices(document, indices)},
                       {"material", 0},
                       {"mode", mode_triangles}};
  document.json["meshes"].push_back(
      {{"name", part.name}, {"primitives", Json::array({primitive})}});
  document.json["nodes"].push_back(
      {{"name", part.name}, {"mesh", document.json["meshes"].size() - 1}});
  return document.json["nodes"].size() - 1;
}

Document make_document(const Mesh& mesh) {
  Document document;
  Json& json = document.json;
  json["asset"] = {{"version", "2.0"}, {"generator", "Bodyline"}};
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", {0}}}});
  // From millimetres with z up to metres with y up: a quarter turn about x.
  const double half = 0.70710678118654752;
  json["nodes"] = Json::array(
      {{{"name", "body"}, {"scale", {1e-3, 1e-3, 1e-3}}, {"rotation", {-half, 0.0, 0.0, half}}}});
  json["materials"] = Json::array({{{"name", "paint"},
                                    {"doubleSided", true},
                                    {"pbrMetallicRoughness",
                                     {{"baseColorFactor", {0.6, 0.62, 0.65, 1.0}},
                                      {"metallicFactor", 0.3},
                                      {"roughnessFactor", 0.35}}}}});
  Json children = Json::array();
  for (const MeshPart& part : mesh.parts)
    if (part.triangles > 0) children.push_back(add_part(document, mesh, part));
  if (!children.empty()) json["nodes"][0]["children"] = children;
  json["buffers"] = Json::array({{{"byteLength", document.buffer.size()}}});
  return document;
}

std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    for (std::size_t l = 0; l < 3; ++l)
      group = group << 8 | (l < count ? static_cast<unsigned char>(bytes[k + l]) : 0u);
    for (std::size_t l = 0; l < 4; ++l)
      text += l <= count ? digits[group >> (18 - 6 * l) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string glb_file(const Mesh& mesh) {
  Document document = make_document(mesh);
  std::string json = document.json.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  document.buffer.resize((document.buffer.size() + 3) / 4 * 4, '\0');
  const std::size_t total = 12 + 8 + json.size() + 8 + document.buffer.size();
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error("the mesh is too large for a .glb file, which holds 4 GB");
  std::string file;
  for (std::uint32_t word : {magic_gltf, std::uint32_t{2}, static_cast<std::uint32_t>(total),
                             static_cast<std::uint32_t>(json.size()), chunk_json})
    append(file, word);
  file += json;
  append(file, static_cast<std::uint32_t>(document.buffer.size()));
  append(file, chunk_binary);
  file += document.buffer;
  return file;
}

std::string gltf_file(const Mesh& mesh) {
  Document document = make_document(mesh);
  document.json["buffers"][0]["uri"] =
      "data:application/octet-stream;base64," + base64(document.buffer);
  return document.json.dump() + "\n";
}

}  // namespace bodyline::io
