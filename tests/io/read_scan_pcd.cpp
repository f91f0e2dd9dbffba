#include "io/lzf.hpp"
#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using testing::bytes_of;
using testing::some_points;
using testing::words_of;

class ReadPcd : public testing::ScanFiles {};

std::string head(std::size_t count, const std::string& data) {
  const std::string points = std::to_string(count);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
         "FIELDS rgb x y z _ normal_x normal_y normal_z\nSIZE 4 4 8 4 1 4 4 4\n"
         "TYPE U F F F U F F F\nCOUNT 1 1 1 1 3 1 1 1\nWIDTH " +
         points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

// The fields of one point, in the order of the head above.
std::vector<std::string> fields(const Eigen::Vector3d& point) {
  return {bytes_of<std::uint32_t>(77),
          bytes_of(float(point.x())),
          bytes_of(point.y()),
          bytes_of(float(point.z())),
          "abc",
          bytes_of(0.0f),
          bytes_of(0.0f),
          bytes_of(-2.0f)};
}

// Stores without packing: runs of up to 32 bytes behind their length less 1.
std::string stored(const std::string& data) {
  std::string packed;
  for (std::size_t k = 0; k < data.size(); k += 32) {
    const std::string run = data.substr(k, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  return packed;
}

std::string compressed(const std::vector<Eigen::Vector3d>& points) {
  std::string columns;
  for (std::size_t f = 0; f < fields(points[0]).size(); ++f) {
    for (const auto& point : points) columns += fields(point)[f];
  }
  const std::string packed = stored(columns);
  return head(points.size(), "binary_compressed") + bytes_of(std::uint32_t(packed.size())) +
         bytes_of(std::uint32_t(columns.size())) + packed;
}

void expect_points(const io::ScanFile& file, const std::string& format) {
  EXPECT_EQ(file.format, format);
  EXPECT_EQ(file.scan.points, some_points(130));
  ASSERT_TRUE(file.with_normals);
  for (const auto& normal : file.scan.normals) EXPECT_EQ(normal, -Eigen::Vector3d::UnitZ());
}

TEST_F(ReadPcd, AllKindsOfDataHoldTheSamePoints) {
  const auto points = some_points(130);
  std::string ascii = head(130, "ascii"), binary = head(130, "binary");
  for (const auto& point : points) {
    ascii += "4.2e7 " + words_of(point) + " 1 2 3 0 0 -1\n";
    for (const std::string& field : fields(point)) binary += field;
  }
  expect_points(read("a.pcd", ascii), "PCD, ASCII");
  expect_points(read("a.pcd", binary), "PCD, binary");
  expect_points(read("a.pcd", compressed(points)), "PCD, compressed");
}

TEST_F(ReadPcd, WidthTimesHeightStandsForThePoints) {
  std::string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 20\nHEIGHT 6\n";
  text += "DATA ascii\n";
  for (const auto& point : some_points(120)) text += words_of(point) + "\n";
  const io::ScanFile file = read("a.pcd", text);
  EXPECT_EQ(file.scan.points, some_points(120));
  EXPECT_FALSE(file.with_normals);
}

TEST_F(ReadPcd, PointsThatWereNotMeasuredAreDropped) {
  std::string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 240\nDATA ascii\n";
  for (const auto& point : some_points(120)) text += words_of(point) + "\nnan nan nan\n";
  const io::ScanFile file = read("a.pcd", text);
  EXPECT_EQ(file.scan.points, some_points(120));
  EXPECT_EQ(file.points_in_file, 240U);
  EXPECT_EQ(file.dropped, 120U);
}

TEST(Lzf, ReferencesMayOverlapWhatTheyWrite) {
  // "ab", then 7 bytes from 2 back, then 10 bytes from 1 back.
  const std::string packed{
      "\x01"
      "ab"
      "\xa0\x01"
      "\xe0\x01\x00",
      8};
  EXPECT_EQ(io::unpacked_lzf(packed, 19), "ababababaaaaaaaaaaa");
}

TEST(Lzf, DamagedDataUnpackToNothing) {
  const std::string good = stored("0123456789");
  EXPECT_EQ(io::unpacked_lzf(good, 10), "0123456789");
  EXPECT_EQ(io::unpacked_lzf(good, 9), "");
  EXPECT_EQ(io::unpacked_lzf(good, 11), "");
  EXPECT_EQ(io::unpacked_lzf(good.substr(0, 5), 10), "");
  EXPECT_EQ(io::unpacked_lzf("\xa0\x01", 7), "");  // refers to before the beginning
  EXPECT_EQ(io::unpacked_lzf("", 10), "");
}

TEST(Lzf, NothingGrowsMoreThanItsBound) {
  std::string packed("\0a", 2);  // literal "a", then the longest references there are
  for (int k = 0; k < 100; ++k) packed += std::string("\xe0\xff\x00", 3);
  const std::size_t size = 1 + 100 * 264;
  EXPECT_EQ(io::unpacked_lzf(packed, size).size(), size);
  EXPECT_LE(size, packed.size() * io::largest_lzf_growth);
}

}  // namespace
}  // namespace bodyline
