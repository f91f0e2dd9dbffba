#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using testing::some_points;
using testing::words_of;

class ReadText : public testing::ScanFiles {
 protected:
  // Lines "x y z REST".
  static std::string rows(int count, const std::string& rest = "",
                          const std::string& separator = " ") {
    std::string text;
    for (const auto& point : some_points(count)) {
      text += words_of(point, separator) + (rest.empty() ? "" : separator + rest) + "\n";
    }
    return text;
  }
};

TEST_F(ReadText, SpacesTabsCommasAndSemicolonsPartNumbers) {
  for (const std::string separator : {" ", "\t", ",", ", ", ";", "  \t "}) {
    for (const std::string name : {"a.xyz", "a.txt", "a.csv", "a.asc", "a.XYZ"}) {
      EXPECT_EQ(read(name, rows(120, "", separator)).scan.points, some_points(120)) << separator;
    }
  }
}

TEST_F(ReadText, DecimalCommasAreReadAsSuch) {
  for (const char separator : {' ', ';', '\t'}) {
    std::string text;
    for (const auto& point : some_points(120)) {
      std::string row = words_of(point, std::string(1, separator));
      std::replace(row.begin(), row.end(), '.', ',');
      text += row + "\n";
    }
    EXPECT_EQ(read("a.csv", text).scan.points, some_points(120)) << separator;
  }
}

TEST_F(ReadText, CommasThatLeaveTooFewNumbersAreRefused) {
  EXPECT_NE(refusal("a.xyz", rows(120) + "1,5 2,3\n"), "");
}

TEST_F(ReadText, CommentsBlankLinesAndOneHeadingArePassedOver) {
  const std::string text = "# made by hand\n\n// X Y Z\nx,y,z\r\n" + rows(60) + "  \n# more\n";
  std::string second;
  for (int k = 60; k < 120; ++k) second += words_of(some_points(120)[k]) + "\r\n";
  EXPECT_EQ(read("a.xyz", text + second).scan.points, some_points(120));
}

TEST_F(ReadText, TheLastLineNeedsNoEnd) {
  std::string text = rows(100);
  text.pop_back();
  EXPECT_EQ(read("a.xyz", text).scan.points, some_points(100));
}

TEST_F(ReadText, SixColumnsOfUnitVectorsAreNormals) {
  const io::ScanFile file = read("a.xyz", rows(100, "0 0.707 -0.71"));
  EXPECT_TRUE(file.with_normals);
  ASSERT_EQ(file.scan.normals.size(), 100U);
  EXPECT_NEAR(file.scan.normals[7].norm(), 1.0, 1e-15);
  EXPECT_LT(file.scan.normals[7].z(), -0.7);
}

TEST_F(ReadText, ColoursAreNoNormals) {
  for (const std::string rest : {"255 0 0", "0.5 0.5 0.5", "120 12 255 30", "0.3"}) {
    const io::ScanFile file = read("a.xyz", rows(100, rest));
    EXPECT_FALSE(file.with_normals) << rest;
    EXPECT_TRUE(file.scan.normals.empty());
    EXPECT_EQ(file.scan.points, some_points(100));
  }
}

TEST_F(ReadText, NormalsMayStandBehindColours) {
  const io::ScanFile file = read("a.xyz", rows(100, "255 128 0 0 1 0"));
  ASSERT_TRUE(file.with_normals);
  EXPECT_EQ(file.scan.normals[5], Eigen::Vector3d::UnitY());
}

TEST_F(ReadText, PtsFilesHoldBlocksWithCounts) {
  std::string text = "60\n", second;
  const auto points = some_points(110);
  for (int k = 0; k < 110; ++k) (k < 60 ? text : second) += words_of(points[k]) + " -3 1 2 3\n";
  EXPECT_EQ(read("a.pts", text + "50\n" + second).scan.points, points);
}

TEST_F(ReadText, PtsFilesNeedNoCount) {
  EXPECT_EQ(read("a.pts", rows(100)).scan.points, some_points(100));
}

TEST_F(ReadText, NumbersMayHaveSignsAndExponents) {
  const std::string text = rows(100) + "+1.5e2 -.25 1E-3\n";
  EXPECT_EQ(read("a.xyz", text).scan.points.back(), Eigen::Vector3d(150, -0.25, 0.001));
}

}  // namespace
}  // namespace bodyline
