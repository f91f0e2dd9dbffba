#include "io/mesh_files.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "export_house.hpp"
#include "mesh_laws.hpp"

namespace bodyline {
namespace {

using namespace test;
using Json = nlohmann::json;

const io::Mesh& house_mesh() {
  static const io::Mesh mesh = io::make_mesh(make_open_house(), {.tolerance_mm = 2.0});
  return mesh;
}

template <typename Value>
Value take(const std::string& file, std::size_t& at) {
  Value value;
  EXPECT_LE(at + sizeof(Value), file.size());
  std::memcpy(&value, file.data() + at, sizeof(Value));
  at += sizeof(Value);
  return value;
}

Eigen::Vector3f take_vector(const std::string& file, std::size_t& at) {
  Eigen::Vector3f v;
  for (int c = 0; c < 3; ++c) v[c] = take<float>(file, at);
  return v;
}

/// The same triangles, corner by corner.
void expect_same_triangles(const std::vector<std::array<Eigen::Vector3f, 3>>& read,
                           const io::Mesh& mesh) {
  ASSERT_EQ(read.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < read.size(); ++t)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(read[t][k], mesh.points[mesh.triangles[t][k]]) << "triangle " << t;
}

TEST(MeshFiles, StlHoldsTheTriangles) {
  const io::Mesh& mesh = house_mesh();
  const std::string file = io::stl_file(mesh);
  EXPECT_NE(file.substr(0, 5), "solid");
  std::size_t at = 80;
  const auto count = take<std::uint32_t>(file, at);
  ASSERT_EQ(file.size(), 84 + 50 * count);
  std::vector<std::array<Eigen::Vector3f, 3>> read;
  for (std::uint32_t t = 0; t < count; ++t) {
    const Eigen::Vector3f normal = take_vector(file, at);
    read.push_back({take_vector(file, at), take_vector(file, at), take_vector(file, at)});
    const auto& [a, b, c] = read.back();
    EXPECT_GT(normal.dot((b - a).cross(c - a).normalized()), 0.999f);
    take<std::uint16_t>(file, at);
  }
  expect_same_triangles(read, mesh);
}

TEST(MeshFiles, ObjHoldsTheTrianglesWithNormalsAndGroups) {
  const io::Mesh& mesh = house_mesh();
  std::istringstream file(io::obj_file(mesh));
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<std::array<Eigen::Vector3f, 3>> read;
  std::vector<std::string> groups;
  std::string line, keyword;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    words >> keyword;
    if (keyword == "v" || keyword == "vn") {
      Eigen::Vector3f v;
      words >> v[0] >> v[1] >> v[2];
      (keyword == "v" ? points : normals).push_back(v);
    } else if (keyword == "g") {
      groups.push_back(line.substr(2));
    } else if (keyword == "f") {
      std::array<Eigen::Vector3f, 3> triangle;
      for (int k = 0; k < 3; ++k) {
        int point = 0, normal = 0;
        char slash;
        words >> point >> slash >> slash >> normal;
        triangle[k] = points.at(point - 1);
        EXPECT_EQ(normals.at(normal - 1), mesh.normals[mesh.triangle_normals[read.size()][k]]);
      }
      read.push_back(triangle);
    }
  }
  expect_same_triangles(read, mesh);
  EXPECT_EQ(points.size(), mesh.points.size());
  ASSERT_EQ(groups.size(), mesh.parts.size());
  for (std::size_t f = 0; f < groups.size(); ++f) EXPECT_EQ(groups[f], mesh.parts[f].name);
}

TEST(MeshFiles, PlyHoldsSharedVerticesAndTriangles) {
  const io::Mesh& mesh = house_mesh();
  const std::string file = io::ply_file(mesh);
  const std::string end = "end_header\n";
  std::size_t at = file.find(end) + end.size();
  EXPECT_NE(file.find("element vertex " + std::to_string(mesh.points.size()) + "\n"),
            std::string::npos);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    points.push_back(take_vector(file, at));
    EXPECT_NEAR(take_vector(file, at).norm(), 1.0f, 1e-5f);
  }
  std::vector<std::array<Eigen::Vector3f, 3>> read;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    ASSERT_EQ(take<std::uint8_t>(file, at), 3);
    std::array<Eigen::Vector3f, 3> triangle;
    for (auto& corner : triangle) corner = points.at(take<std::int32_t>(file, at));
    read.push_back(triangle);
  }
  EXPECT_EQ(at, file.size());
  expect_same_triangles(read, mesh);
}

/// Checks what the specification demands of accessors and views, and returns the triangles in
/// order.
std::vector<std::array<Eigen::Vector3f, 3>> read_gltf(const Json& json, const std::string& buffer) {
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["buffers"].size(), 1u);
  for (const Json& view : json["bufferViews"])
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              buffer.size());
  const auto offset = [&](const Json& accessor) {
    const Json& view = json["bufferViews"][accessor["bufferView"].get<int>()];
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    const std::size_t size = accessor["type"] == "VEC3" ? 12 : 4;
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), size * accessor["count"].get<std::size_t>());
    return view["byteOffset"].get<std::size_t>();
  };
  std::vector<std::array<Eigen::Vector3f, 3>> read;
  for (const Json& child : json["nodes"][0]["children"]) {
    const Json& node = json["nodes"][child.get<int>()];
    const Json& mesh = json["meshes"][node["mesh"].get<int>()];
    EXPECT_EQ(node["name"], mesh["name"]);
    const Json& primitive = mesh["primitives"][0];
    const Json& position = json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    const Json& normal = json["accessors"][primitive["attributes"]["NORMAL"].get<int>()];
    const Json& indices = json["accessors"][primitive["indices"].get<int>()];
    EXPECT_EQ(position["count"], normal["count"]);
    std::vector<Eigen::Vector3f> points;
    std::size_t at = offset(position), at_normal = offset(normal), at_index = offset(indices);
    for (std::size_t p = 0; p < position["count"]; ++p) {
      points.push_back(take_vector(buffer, at));
      EXPECT_NEAR(take_vector(buffer, at_normal).norm(), 1.0f, 1e-6f);
      for (int c = 0; c < 3; ++c) {
        EXPECT_LE(position["min"][c].get<float>(), points.back()[c]);
        EXPECT_GE(position["max"][c].get<float>(), points.back()[c]);
      }
    }
    for (std::size_t k = 0; k < indices["count"]; k += 3) {
      std::array<Eigen::Vector3f, 3> triangle;
      for (auto& corner : triangle) corner = points.at(take<std::uint32_t>(buffer, at_index));
      read.push_back(triangle);
    }
  }
  return read;
}

TEST(MeshFiles, GlbIsValidAndHoldsTheTriangles) {
  const io::Mesh& mesh = house_mesh();
  const std::string file = io::glb_file(mesh);
  std::size_t at = 0;
  EXPECT_EQ(file.substr(0, 4), "glTF");
  at = 4;
  EXPECT_EQ(take<std::uint32_t>(file, at), 2u);
  EXPECT_EQ(take<std::uint32_t>(file, at), file.size());
  const auto json_size = take<std::uint32_t>(file, at);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(file.substr(at, 4), "JSON");
  const Json json = Json::parse(file.substr(at + 4, json_size));
  at += 4 + json_size;
  const auto buffer_size = take<std::uint32_t>(file, at);
  EXPECT_EQ(file.substr(at, 3), "BIN");
  at += 4;
  EXPECT_EQ(at + buffer_size, file.size());
  EXPECT_LE(json["buffers"][0]["byteLength"].get<std::size_t>(), buffer_size);
  expect_same_triangles(read_gltf(json, file.substr(at)), mesh);
  for (std::size_t f = 0; f < mesh.parts.size(); ++f)
    EXPECT_EQ(json["nodes"][f + 1]["name"], mesh.parts[f].name);
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

TEST(MeshFiles, GltfEmbedsTheSameBufferAsGlb) {
  const io::Mesh& mesh = house_mesh();
  const Json json = Json::parse(io::gltf_file(mesh));
  const std::string uri = json["buffers"][0]["uri"];
  const std::string head = "data:application/octet-stream;base64,";
  ASSERT_TRUE(uri.starts_with(head));
  const std::string buffer = from_base64(uri.substr(head.size()));
  EXPECT_EQ(buffer.size(), json["buffers"][0]["byteLength"].get<std::size_t>());
  expect_same_triangles(read_gltf(json, buffer), mesh);
}

}  // namespace
}  // namespace bodyline
