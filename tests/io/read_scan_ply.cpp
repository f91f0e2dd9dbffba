#include "io/write_scan.hpp"
#include "model/random.hpp"
#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using io::ByteOrder;
using testing::bytes_of;
using testing::some_points;
using testing::words_of;

class ReadPly : public testing::ScanFiles {};

std::string format_line(ByteOrder order) {
  return order == ByteOrder::big ? "format binary_big_endian 1.0\n"
                                 : "format binary_little_endian 1.0\n";
}

std::string vertex_head(std::size_t count, const std::string& type) {
  std::string text = "element vertex " + std::to_string(count) + "\n";
  for (const char* name : {"x", "y", "z"}) text += "property " + type + " " + name + "\n";
  return text;
}

template <typename Number>
std::string binary_ply(const std::vector<Eigen::Vector3d>& points, const std::string& type,
                       ByteOrder order) {
  std::string text =
      "ply\n" + format_line(order) + vertex_head(points.size(), type) + "end_header\n";
  for (const auto& point : points) text += bytes_of<Number>(point, order);
  return text;
}

TEST_F(ReadPly, AllFormatsHoldTheSamePoints) {
  const auto points = some_points(150);
  std::string ascii = "ply\nformat ascii 1.0\n" + vertex_head(150, "float") + "end_header\n";
  for (const auto& point : points) ascii += words_of(point) + "\n";
  EXPECT_EQ(read("a.ply", ascii).scan.points, points);
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    EXPECT_EQ(read("f.ply", binary_ply<float>(points, "float", order)).scan.points, points);
    EXPECT_EQ(read("d.ply", binary_ply<double>(points, "double", order)).scan.points, points);
    EXPECT_EQ(read("g.PLY", binary_ply<float>(points, "float32", order)).scan.points, points);
  }
}

TEST_F(ReadPly, TheFormatIsNamed) {
  const auto points = some_points(100);
  EXPECT_EQ(read("a.ply", binary_ply<float>(points, "float", ByteOrder::big)).format,
            "PLY, binary big endian");
}

template <typename Number>
void expect_whole_numbers(const std::string& text, const io::ScanFile& file) {
  for (std::size_t k = 0; k < file.scan.points.size(); ++k) {
    const auto number = static_cast<double>(static_cast<Number>(k));
    EXPECT_EQ(file.scan.points[k], Eigen::Vector3d::Constant(number)) << text;
  }
}

TEST_F(ReadPly, EveryTypeOfNumberIsReadInBothOrders) {
  const auto check = [this]<typename Number>(Number, const std::string& type) {
    for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
      std::string text = "ply\n" + format_line(order) + vertex_head(200, type) + "end_header\n";
      for (int k = 0; k < 200; ++k) {
        for (int c = 0; c < 3; ++c) text += bytes_of(static_cast<Number>(k), order);
      }
      expect_whole_numbers<Number>(type, read("a.ply", text));
    }
  };
  check(std::int8_t{}, "char");
  check(std::uint8_t{}, "uchar");
  check(std::int16_t{}, "short");
  check(std::uint16_t{}, "ushort");
  check(std::int32_t{}, "int");
  check(std::uint32_t{}, "uint");
  check(std::int64_t{}, "int64");
  check(std::uint64_t{}, "uint64");
  check(float{}, "float");
  check(double{}, "double");
}

TEST_F(ReadPly, NormalsGetUnitLength) {
  std::string text = "ply\nformat ascii 1.0\n" + vertex_head(100, "float");
  text += "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
  for (const auto& point : some_points(100)) text += words_of(point) + " 0 3 -4\n";
  const io::ScanFile file = read("a.ply", text);
  EXPECT_TRUE(file.with_normals);
  ASSERT_EQ(file.scan.normals.size(), 100U);
  for (const auto& normal : file.scan.normals) {
    EXPECT_TRUE(normal.isApprox(Eigen::Vector3d(0, 0.6, -0.8), 1e-15));
  }
}

// Elements before and after the vertices, properties between theirs, lists among both.
TEST_F(ReadPly, UnknownPropertiesAndElementsArePassedOver) {
  const auto points = some_points(120);
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    std::string text = "ply\r\n" + format_line(order);
    text += "comment made by hand\r\nobj_info none\nelement camera 2\n";
    text += "property list uchar double values\nproperty short id\n";
    text += "element vertex 120\nproperty uchar red\nproperty double x\n";
    text += "property list int ushort near\nproperty float y\nproperty float quality\n";
    text += "property int64 z4\nproperty double z\nelement edge 1\nproperty int a\nend_header\n";
    for (int k = 0; k < 2; ++k) {
      text += bytes_of<std::uint8_t>(3, order);
      text += bytes_of<double>({1, 2, 3}, order) + bytes_of<std::int16_t>(7, order);
    }
    for (const auto& point : points) {
      text += bytes_of<std::uint8_t>(9, order) + bytes_of(point.x(), order);
      text += bytes_of<std::int32_t>(2, order);
      text += bytes_of<std::uint16_t>(5, order) + bytes_of<std::uint16_t>(6, order);
      text += bytes_of(float(point.y()), order) + bytes_of(1.0f, order);
      text += bytes_of<std::int64_t>(-8, order) + bytes_of(point.z(), order);
    }
    text += bytes_of<std::int32_t>(1, order);
    EXPECT_EQ(read("a.ply", text).scan.points, points);
  }
}

std::string box_ply_ascii(const std::string& list_name) {
  std::string text = "ply\nformat ascii 1.0\n" + vertex_head(8, "float");
  text += "element face 6\nproperty list uchar int " + list_name + "\nproperty uchar red\n";
  text += "end_header\n";
  for (const auto& point : testing::box_points()) text += words_of(point) + "\n";
  for (const auto& side : testing::box_sides) {
    text += "4";
    for (const int corner : side) text += " " + std::to_string(corner);
    text += " 200\n";
  }
  return text;
}

TEST_F(ReadPly, AMeshBecomesPointsOnItsFaces) {
  for (const std::string name : {"vertex_indices", "vertex_index"}) {
    const io::ScanFile file = read("a.ply", box_ply_ascii(name), {.mesh_points = 14'000});
    testing::expect_points_on_box(file, 14'000);
    EXPECT_EQ(file.points_in_file, 8U);
  }
}

TEST_F(ReadPly, FacesMayStandBeforeTheVertices) {
  std::string text = "ply\n" + format_line(ByteOrder::big) + "element face 12\n";
  text += "property list uchar uint vertex_indices\n" + vertex_head(8, "double") + "end_header\n";
  for (const auto& triangle : testing::box_triangles()) {
    text += bytes_of<std::uint8_t>(3);
    for (const int corner : triangle) text += bytes_of<std::uint32_t>(corner, ByteOrder::big);
  }
  for (const auto& point : testing::box_points()) text += bytes_of<double>(point, ByteOrder::big);
  testing::expect_points_on_box(read("a.ply", text, {.mesh_points = 1400}), 1400);
}

TEST_F(ReadPly, AMeshGetsNoMorePointsThanAreWanted) {
  const io::ReadScanOptions options{.most_points = 140, .mesh_points = 5000};
  EXPECT_EQ(read("a.ply", box_ply_ascii("vertex_index"), options).scan.points.size(), 140U);
}

TEST_F(ReadPly, AWrittenScanComesBack) {
  model::Scan scan;
  model::Random random(3);
  for (int k = 0; k < 500; ++k) {
    scan.points.emplace_back(1e3 * random.normal(), random.normal(), 1e-3 * random.normal());
    scan.normals.push_back(random.direction());
  }
  io::write_scan(scan, folder_ / "a.ply");
  const io::ScanFile file = io::read_scan(folder_ / "a.ply");
  EXPECT_EQ(file.scan.points, scan.points);
  ASSERT_EQ(file.scan.normals.size(), scan.normals.size());
  for (std::size_t k = 0; k < scan.normals.size(); ++k) {
    // Normals are written in single precision.
    EXPECT_LT((file.scan.normals[k] - scan.normals[k]).norm(), 1e-6);
  }
  scan.normals.clear();
  io::write_scan(scan, folder_ / "a.ply", io::Overwrite::allowed);
  const io::ScanFile again = io::read_scan(folder_ / "a.ply");
  EXPECT_EQ(again.scan.points, scan.points);
  EXPECT_FALSE(again.with_normals);
}

TEST_F(ReadPly, ScansWithTooFewNormalsAreNotWritten) {
  model::Scan scan{some_points(10), {Eigen::Vector3d::UnitX()}};
  EXPECT_THROW(io::write_scan(scan, folder_ / "a.ply"), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.ply"));
}

}  // namespace
}  // namespace bodyline
