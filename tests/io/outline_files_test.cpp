// Outlines that are written are read again; polylines in space.

#include <gmock/gmock.h>

#include "io/read_drawing.hpp"
#include "io/read_polylines.hpp"
#include "io/write_outline.hpp"
#include "tests/io/drawing_support.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr double written = 0.0005;  // mm: files hold thousandths

class OutlineFiles : public testing::DrawingFiles {
 protected:
  const std::vector<std::vector<Vector2d>> lines_{
      {{0.12345, 0.0}, {4700.0, 0.0}, {4600.5, 1200.25}, {-25.125, 800.0}, {0.12345, 0.0}},
      {{100.0, 2000.0}, {300.0, 2100.0}}};
};

TEST_F(OutlineFiles, AreReadAsTheyWereWritten) {
  for (const std::string name : {"a.svg", "a.csv"}) {
    io::write_outline(lines_, "side", (folder_ / name));
    const model::Drawing drawing = io::read_drawing((folder_ / name));
    ASSERT_EQ(drawing.paths.size(), 2U) << name;
    EXPECT_TRUE(drawing.paths[0].closed);
    EXPECT_FALSE(drawing.paths[1].closed);
    for (std::size_t line = 0; line < 2; ++line) {
      ASSERT_EQ(drawing.paths[line].segments.size() + 1, lines_[line].size());
      for (std::size_t k = 1; k < lines_[line].size(); ++k)
        EXPECT_LE((drawing.paths[line].segments[k - 1].points[3] - lines_[line][k]).norm(),
                  2.0 * written);
    }
  }
  EXPECT_EQ(io::read_drawing((folder_ / "a.svg")).unit_mm, 1.0);  // full size
}

TEST_F(OutlineFiles, HaveAKnownExtensionAndReplaceNothing) {
  EXPECT_THROW(io::write_outline(lines_, "side", (folder_ / "a.dxf")), std::invalid_argument);
  io::write_outline(lines_, "side", (folder_ / "a.csv"));
  EXPECT_THROW(io::write_outline(lines_, "side", (folder_ / "a.csv")), io::InputError);
}

class Polylines : public testing::DrawingFiles {
 protected:
  std::vector<std::vector<Vector3d>> lines(const std::string& text) const {
    return io::read_polylines(file("a.csv", text));
  }
  std::string sentence(const std::string& text) const {
    try {
      lines(text);
    } catch (const io::InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(Polylines, ArePointsALineAndPartedByBlankOnes) {
  const auto read =
      lines("x,y,z\n1,2,3\n4;5;6  # the end\n# of it\n7 8 9\n\n0,0,0\r\n1,0,-0.5\r\n");
  ASSERT_EQ(read.size(), 2U);
  ASSERT_EQ(read[0].size(), 3U);
  EXPECT_EQ(read[0][1], Vector3d(4, 5, 6));
  EXPECT_EQ(read[1][1], Vector3d(1, 0, -0.5));
}

TEST_F(Polylines, AreRefusedWithFileAndLine) {
  EXPECT_THAT(sentence("1,2,3\n4,5\n"), HasSubstr("a.csv:2: "));
  EXPECT_THAT(sentence("1,2,3\n4,5,6,7\n"), HasSubstr("there is more"));
  EXPECT_THAT(sentence("1,2,3\n4,5,nan\n"), HasSubstr("finite"));
  EXPECT_THAT(sentence("1,2,3\n\n4,5,6\n7,8,9\n"), HasSubstr("single point"));
  EXPECT_THAT(sentence("x,y,z\nu,v,w\n1,2,3\n"), HasSubstr("is no point x y z"));
  EXPECT_THAT(sentence("# nothing\n"), HasSubstr("has no points"));
}

}  // namespace
}  // namespace bodyline
