#include <cmath>
#include <random>

#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using testing::bytes_of;
using testing::lines;
using testing::pcd;
using testing::ply;
using testing::some_points;
using testing::words_of;

class ReadScan : public testing::ScanFiles {
 protected:
  // Bytes of the file that cannot be left out; what follows may be.
  void expect_refused_when_cut(const std::string& name, const std::string& content,
                               std::size_t needed) const {
    for (std::size_t size = 0; size < needed; size += 1 + content.size() / 97) {
      EXPECT_NE(refusal(name, content.substr(0, size)), "") << name << " " << size;
    }
  }
};

TEST_F(ReadScan, MissingFilesAndFoldersAreNamed) {
  const auto sentence = [](const std::filesystem::path& path) -> std::string {
    try {
      io::read_scan(path);
    } catch (const io::InputError& error) {
      return error.sentence();
    }
    return "";
  };
  std::filesystem::create_directory(folder_ / "folder.ply");
  EXPECT_EQ(sentence(folder_ / "none.ply"), "does not exist.");
  EXPECT_EQ(sentence(folder_ / "none.stl"), "does not exist.");
  EXPECT_EQ(sentence(folder_ / "folder.ply"), "is a folder, not a scan.");
}

TEST_F(ReadScan, CutOffAnywhereItIsRefused) {
  const std::string binary(100 * 12, '\0');
  const std::string packed(100 * 12 / 32 * 33 + 17, '\x1f');
  for (const std::string order : {"binary_little_endian", "binary_big_endian"}) {
    const std::string text = ply("100", "", order) + binary;
    expect_refused_when_cut("a.ply", text, text.size());
  }
  const std::string pcd_text = pcd("100", "binary") + binary;
  expect_refused_when_cut("a.pcd", pcd_text, pcd_text.size());
  const std::string compressed = pcd("100", "binary_compressed") +
                                 bytes_of(std::uint32_t(packed.size())) +
                                 bytes_of<std::uint32_t>(1200) + packed;
  expect_refused_when_cut("a.pcd", compressed, compressed.size());
  // A last number may be short and still be one.
  const std::string last = "99 0.5 0\n";
  for (const auto& [name, head] : std::vector<std::pair<std::string, std::string>>{
           {"a.ply", ply("100")}, {"a.pcd", pcd("100")}, {"a.pts", "100\n"}}) {
    const std::string content = head + lines(100);
    expect_refused_when_cut(name, content, content.size() - last.size());
  }
}

// A few bytes changed at random, in every format that has a reader of our own.
TEST_F(ReadScan, DamagedAnywhereItReadsOrIsRefused) {
  constexpr int trials = 60;
  const std::string stl =
      std::string(80, ' ') + bytes_of<std::uint32_t>(24) + std::string(24 * 50, '\x3f');
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.ply", ply("100") + lines(100)},
      {"a.ply", ply("100", testing::face, "binary_big_endian") + std::string(1213, '\0')},
      {"a.pcd", pcd("100", "binary") + std::string(1200, '\0')},
      {"a.pts", "100\n" + lines(100)},
      {"a.stl", stl},
      {"a.off", "OFF\n100 1 0\n" + lines(100) + "3 0 1 2\n"}};
  std::mt19937 random(7);
  for (const auto& [name, content] : files) {
    for (int trial = 0; trial < trials; ++trial) {
      std::string damaged = content;
      for (int k = 0; k < 4; ++k) {
        // Most of what can go wrong is at the front.
        const std::size_t at = random() % (k % 2 == 0 ? 200 : content.size());
        damaged[at] = static_cast<char>(random() % 3 == 0 ? random() : '0' + random() % 10);
      }
      const std::string sentence = refusal(name, damaged);  // anything but InputError fails
      EXPECT_EQ(sentence.empty() || sentence.ends_with('.'), true) << sentence;
    }
  }
}

TEST_F(ReadScan, AFewPointsThatAreNotFiniteAreDroppedAndCounted) {
  const io::ScanFile scan = read("a.xyz", lines(70) + "nan 0 0\n1 inf 2\n" + lines(50));
  EXPECT_EQ(scan.scan.points.size(), 120U);
  EXPECT_EQ(scan.points_in_file, 122U);
  EXPECT_EQ(scan.dropped, 2U);
}

TEST_F(ReadScan, PointsWithoutANormalAreDroppedWhereTheOthersHaveOne) {
  std::string content = ply("200", "property float nx\nproperty float ny\nproperty float nz\n");
  const auto points = some_points(200);
  for (int k = 0; k < 200; ++k) content += words_of(points[k]) + (k < 90 ? " 0 0 0\n" : " 1 0 0\n");
  const io::ScanFile scan = read("a.ply", content);
  EXPECT_TRUE(scan.with_normals);
  EXPECT_EQ(scan.scan.points.size(), 110U);
  EXPECT_EQ(scan.scan.normals.size(), 110U);
  EXPECT_EQ(scan.dropped, 90U);
}

TEST_F(ReadScan, NormalsThatMostPointsLackAreLeftOut) {
  std::string content = ply("200", "property float nx\nproperty float ny\nproperty float nz\n");
  const auto points = some_points(200);
  for (int k = 0; k < 200; ++k) {
    content += words_of(points[k]) + (k < 110 ? " nan 0 0\n" : " 1 0 0\n");
  }
  const io::ScanFile scan = read("a.ply", content);
  EXPECT_FALSE(scan.with_normals);
  EXPECT_TRUE(scan.scan.normals.empty());
  EXPECT_EQ(scan.scan.points, points);
  EXPECT_EQ(scan.dropped, 0U);
}

TEST_F(ReadScan, OptionsBelowAScanAreRefused) {
  const auto path = file("a.xyz", lines(200));
  EXPECT_THROW(io::read_scan(path, {.most_points = 99}), std::invalid_argument);
  EXPECT_THROW(io::read_scan(path, {.mesh_points = 0}), std::invalid_argument);
}

class Thinning : public testing::ScanFiles {
 protected:
  static constexpr int points = 20'000;
  static constexpr std::size_t kept = 2000;
  // In the three kinds of files of points.
  static std::vector<std::pair<std::string, std::string>> files() {
    return {{"a.xyz", lines(points)},
            {"a.ply", ply(std::to_string(points)) + lines(points)},
            {"a.pcd", pcd(std::to_string(points)) + lines(points)}};
  }
};

TEST_F(Thinning, KeepsAsManyPointsAsWantedInTheirOrder) {
  for (const auto& [name, content] : files()) {
    const io::ScanFile scan = read(name, content, {.most_points = kept});
    EXPECT_EQ(scan.points_in_file, std::size_t(points));
    ASSERT_EQ(scan.scan.points.size(), kept);
    for (std::size_t k = 1; k < kept; ++k) {
      // The first coordinate counts the points of the file.
      ASSERT_LT(scan.scan.points[k - 1].x(), scan.scan.points[k].x());
    }
  }
}

TEST_F(Thinning, KeepsFilesThatAreNotLarger) {
  for (const auto& [name, content] : files()) {
    EXPECT_EQ(read(name, content, {.most_points = points}).scan.points, some_points(points));
  }
}

TEST_F(Thinning, IsEvenOverTheFile) {
  constexpr int parts = 20;
  const io::ScanFile scan = read("a.xyz", lines(points), {.most_points = kept});
  std::array<int, parts> counts{};
  for (const auto& point : scan.scan.points) ++counts[int(point.x()) * parts / points];
  const double share = 1.0 / parts;
  const double deviation = std::sqrt(kept * share * (1 - share) * (1 - double(kept) / points));
  for (const int count : counts) EXPECT_NEAR(count, kept * share, 5.0 * deviation);
}

TEST_F(Thinning, DependsOnTheSeedOnly) {
  const auto [name, content] = files()[1];
  const io::ReadScanOptions options{.most_points = kept}, other{.most_points = kept, .seed = 2};
  EXPECT_EQ(read(name, content, options).scan.points, read(name, content, options).scan.points);
  EXPECT_NE(read(name, content, options).scan.points, read(name, content, other).scan.points);
}

}  // namespace
}  // namespace bodyline
