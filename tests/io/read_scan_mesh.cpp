#include "io/scan_mesh.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using Json = nlohmann::json;
using testing::box_points;
using testing::box_triangles;
using testing::bytes_of;
using testing::words_of;

constexpr std::size_t count = 7000;
const io::ReadScanOptions options{.mesh_points = count};

class ReadMesh : public testing::ScanFiles {};

std::string stl_binary() {
  std::string text(80, ' ');
  text += bytes_of<std::uint32_t>(12);
  for (const auto& triangle : box_triangles()) {
    text += bytes_of<float>(Eigen::Vector3d::Zero());
    for (const int corner : triangle) text += bytes_of<float>(box_points()[corner]);
    text += std::string(2, '\0');
  }
  return text;
}

std::string stl_ascii() {
  std::string text = "solid box\n";
  for (const auto& triangle : box_triangles()) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int corner : triangle) text += "vertex " + words_of(box_points()[corner]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::string obj() {
  std::string text = "# box\n";
  for (const auto& point : box_points()) text += "v " + words_of(point) + "\n";
  for (const auto& side : testing::box_sides) {
    text += "f";
    for (const int corner : side) text += " " + std::to_string(corner + 1);
    text += "\n";
  }
  return text;
}

std::string off() {
  std::string text = "OFF\n8 12 0\n";
  for (const auto& point : box_points()) text += words_of(point) + "\n";
  for (const auto& [a, b, c] : box_triangles()) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

// Vertices, then indices; in a file of its own or, for GLB, behind the JSON.
std::string gltf_buffer() {
  std::string buffer;
  for (const auto& point : box_points()) buffer += bytes_of<float>(point);
  for (const auto& triangle : box_triangles()) {
    for (const int corner : triangle) buffer += bytes_of<std::uint32_t>(corner);
  }
  return buffer;
}

Json gltf(const Json& node, int mode = 4) {
  Json primitive{{"attributes", {{"POSITION", 0}}}, {"mode", mode}};
  if (mode == 4) primitive["indices"] = 1;
  return {{"asset", {{"version", "2.0"}}},
          {"scene", 0},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes", Json::array({node})},
          {"meshes", {{{"primitives", Json::array({primitive})}}}},
          {"accessors",
           {{{"bufferView", 0}, {"componentType", 5126}, {"count", 8}, {"type", "VEC3"}},
            {{"bufferView", 1}, {"componentType", 5125}, {"count", 36}, {"type", "SCALAR"}}}},
          {"bufferViews",
           {{{"buffer", 0}, {"byteLength", 96}},
            {{"buffer", 0}, {"byteOffset", 96}, {"byteLength", 144}}}},
          {"buffers", Json::array({{{"byteLength", 240}, {"uri", "box.bin"}}})}};
}

std::string glb() {
  Json document = gltf({{"mesh", 0}});
  document["buffers"][0].erase("uri");
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer();
  const auto size = std::uint32_t(28 + text.size() + buffer.size());
  return "glTF" + bytes_of<std::uint32_t>(2) + bytes_of(size) +
         bytes_of(std::uint32_t(text.size())) + "JSON" + text +
         bytes_of(std::uint32_t(buffer.size())) + std::string("BIN\0", 4) + buffer;
}

TEST_F(ReadMesh, EveryFormatGivesPointsOnTheFaces) {
  file("box.bin", gltf_buffer());
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"binary.stl", stl_binary()},
                                                        {"ascii.stl", stl_ascii()},
                                                        {"box.obj", obj()},
                                                        {"box.off", off()},
                                                        {"box.gltf", gltf({{"mesh", 0}}).dump()},
                                                        {"box.glb", glb()}}) {
    SCOPED_TRACE(name);
    testing::expect_points_on_box(read(name, text, options), count);
  }
}

TEST_F(ReadMesh, OffFilesMayHaveCommentsPolygonsAndColours) {
  std::string text = "COFF 8 6 12 # counts\n";
  for (const auto& point : box_points()) text += words_of(point) + " 1 0 0 1\n\n# more\n";
  for (const auto& side : testing::box_sides) {
    text += "4";
    for (const int corner : side) text += " " + std::to_string(corner);
    text += " 0.5 0.5 0.5\n";
  }
  testing::expect_points_on_box(read("a.off", text, options), count);
}

TEST_F(ReadMesh, ABinaryStlMayBeginWithSolid) {
  const std::string text = "solid" + stl_binary().substr(5);
  EXPECT_EQ(read("a.stl", text, options).format, "STL, binary");
}

TEST_F(ReadMesh, OffFilesWithoutFacesArePoints) {
  const std::string text = "OFF\n130 0 0\n" + testing::lines(130);
  EXPECT_EQ(read("a.off", text).scan.points, testing::some_points(130));
}

TEST_F(ReadMesh, NodesOfGltfPlaceTheirMeshes) {
  file("box.bin", gltf_buffer());
  const Json node{{"mesh", 0}, {"scale", {10, 10, 10}}};
  testing::expect_points_on_box(read("a.gltf", gltf(node).dump(), options), count, 10.0);
}

TEST_F(ReadMesh, AMirroredNodeKeepsItsNormalsOutside) {
  file("box.bin", gltf_buffer());
  const Json node{{"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {4, 0, 0}}};
  testing::expect_points_on_box(read("a.gltf", gltf(node).dump(), options), count);
}

TEST_F(ReadMesh, FilesWithoutFacesArePoints) {
  std::string text;
  for (const auto& point : testing::some_points(130)) text += "v " + words_of(point) + "\n";
  const io::ScanFile file = read("a.obj", text);
  EXPECT_FALSE(file.mesh);
  EXPECT_EQ(file.scan.points, testing::some_points(130));
}

TEST_F(ReadMesh, TheSameSeedGivesTheSameBits) {
  const io::ScanFile once = read("a.obj", obj(), options), again = read("a.obj", obj(), options);
  EXPECT_EQ(once.scan.points, again.scan.points);
  EXPECT_EQ(once.scan.normals, again.scan.normals);
  const io::ScanFile other = read("a.obj", obj(), {.mesh_points = count, .seed = 2});
  EXPECT_NE(once.scan.points, other.scan.points);
}

// The four triangles between the middles of the sides have the same area.
TEST(SampleMesh, PointsAreUniformWithinATriangle) {
  const io::ScanMesh mesh{{{0, 0, 0}, {6, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  constexpr std::size_t points = 40'000;
  std::array<int, 4> counts{};
  for (const auto& point : io::sample_mesh(mesh, points, 5).points) {
    const double s = point.x() / 6, t = point.y() / 2;
    ++counts[s > 0.5 ? 0 : t > 0.5 ? 1 : s + t < 0.5 ? 2 : 3];
  }
  const double deviation = std::sqrt(points * 0.25 * 0.75);
  for (const int number : counts) EXPECT_NEAR(number, points / 4.0, 5.0 * deviation);
}

TEST(SampleMesh, TrianglesWithUnusablePointsGetNone) {
  const double nan = std::nan("");
  const io::ScanMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {1e300, 0, 0}},
                          {{0, 1, 3}, {0, 1, 2}, {0, 2, 4}, {1, 1, 2}}};
  const model::Scan scan = io::sample_mesh(mesh, 500, 1);
  ASSERT_EQ(scan.points.size(), 500U);
  for (const auto& point : scan.points) {
    EXPECT_TRUE((point.array() >= 0.0).all() && point.sum() <= 1.0) << point.transpose();
  }
}

TEST_F(ReadMesh, HostileGltfIsRefused) {
  file("box.bin", gltf_buffer());
  Json twice = gltf({{"children", {1, 1}}});
  twice["nodes"].push_back({{"mesh", 0}});
  EXPECT_THAT(refusal("a.gltf", twice.dump()), ::testing::HasSubstr("node 1 has two parents"));
  Json nothing = gltf({{"mesh", 0}});
  nothing["accessors"][0] = {{"componentType", 5126}, {"count", 4'000'000'000}, {"type", "VEC3"}};
  EXPECT_THAT(refusal("a.gltf", nothing.dump()),
              ::testing::HasSubstr("accessor of 4000000000 numbers has no data"));
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_THAT(refusal("a.gltf", deep), ::testing::HasSubstr("nested too deep"));
  EXPECT_THAT(refusal("a.gltf", "{\"asset\": }"), ::testing::HasSubstr("damaged at byte 11"));
}

// What is left of a file may still be a mesh, but never more than a refusal comes of it.
TEST_F(ReadMesh, CutOffAnywhereItReadsOrIsRefused) {
  file("box.bin", gltf_buffer());
  const io::ReadScanOptions few{.mesh_points = 100};
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"a.stl", stl_binary()},
                                                        {"b.stl", stl_ascii()},
                                                        {"c.obj", obj()},
                                                        {"d.off", off()},
                                                        {"e.gltf", gltf({{"mesh", 0}}).dump()},
                                                        {"f.glb", glb()}}) {
    int refused = 0;
    for (std::size_t size = 0; size < text.size(); size += 1 + text.size() / 61) {
      try {
        EXPECT_EQ(read(name, text.substr(0, size), few).scan.points.size(), 100U);
      } catch (const io::InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 10) << name;
  }
}

}  // namespace
}  // namespace bodyline
