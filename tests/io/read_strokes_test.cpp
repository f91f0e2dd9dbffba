#include "io/read_strokes.hpp"

#include <gtest/gtest.h>

#include "io/input_error.hpp"
#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using Eigen::Vector3d;

class StrokeFiles : public testing::ScanFiles {
 protected:
  std::vector<model::Stroke> read(const std::string& name, const std::string& content) {
    return io::read_strokes(file(name, content));
  }
  std::string refusal(const std::string& name, const std::string& content) {
    const auto path = file(name, content);
    try {
      io::read_strokes(path);
    } catch (const io::InputError& error) {
      const std::string what = error.what();
      return what.substr(what.find(name) + name.size());
    }
    return "read";
  }
};

TEST_F(StrokeFiles, TextHasAStrokeBetweenBlankLines) {
  const auto strokes = read("a.txt", "# two strokes\n0 0 0\n1 2 3\n\n\n4 5 6\n7 8 9\n1e1 0 -2\n");
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0].name, "stroke 1");
  EXPECT_EQ(strokes[0].points, (std::vector<Vector3d>{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_EQ(strokes[1].points.size(), 3u);
}

TEST_F(StrokeFiles, ColumnsAreTakenByTheirHeadings) {
  const auto strokes =
      read("a.csv", "z,y,x,stroke\n1,2,3,rim\n4,5,6,rim\n7,8,9,keel\n1,1,1,keel\n");
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0].name, "rim");
  EXPECT_EQ(strokes[1].name, "keel");
  EXPECT_EQ(strokes[0].points[0], Vector3d(3, 2, 1));
}

TEST_F(StrokeFiles, FourColumnsBeginWithTheName) {
  const auto strokes = read("a.csv", "a;0;0;0\na;1;0;0\nb;2;0;0\nb;3;0;0\n");
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[1].name, "b");
}

TEST_F(StrokeFiles, ObjLinesAreStrokes) {
  const auto strokes =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\ng rim\nl 1 2 3\nv 5 5 5\ng\nl -1 1/7 2\n");
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0].name, "rim");
  EXPECT_EQ(strokes[1].points, (std::vector<Vector3d>{{5, 5, 5}, {0, 0, 0}, {1, 0, 0}}));
}

TEST_F(StrokeFiles, ObjSegmentsThatHangTogetherAreOneStroke) {
  const auto strokes =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\no curve\nl 2 3\nl 1 2\nl 4 3\n");
  ASSERT_EQ(strokes.size(), 1u);
  ASSERT_EQ(strokes[0].points.size(), 4u);
  EXPECT_NEAR(std::abs(strokes[0].points.back().x() - strokes[0].points.front().x()), 3.0, 0.0);
}

TEST_F(StrokeFiles, JsonHoldsPointsWithOrWithoutNames) {
  const auto strokes =
      read("a.json",
           R"({"strokes": [{"name": "rim", "points": [[0,0,0],[1,2,3]]}, [[4,5,6],[7,8,9]]]})");
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0].name, "rim");
  EXPECT_EQ(strokes[1].name, "stroke 2");
  EXPECT_EQ(strokes[1].points[1], Vector3d(7, 8, 9));
}

TEST_F(StrokeFiles, EqualNamesAreNumbered) {
  const auto strokes = read("a.json", R"([{"name": "a", "points": [[0,0,0]]},
                                          {"name": "a", "points": [[1,1,1]]}])");
  EXPECT_EQ(strokes[0].name, "a");
  EXPECT_EQ(strokes[1].name, "a.2");
}

TEST_F(StrokeFiles, AreRefusedWithASentence) {
  EXPECT_EQ(refusal("a.las", "x"),
            ": is of no known format of strokes; those are .obj, .csv, .txt, .xyz, .json.");
  EXPECT_EQ(refusal("a.json", "{"), ": is no JSON.");
  EXPECT_EQ(refusal("a.json", "{}"), ": strokes: must be a list of strokes.");
  EXPECT_EQ(refusal("a.json", "[[[0, 0]]]"), ": strokes[0][0]: must be a point [x, y, z].");
  EXPECT_EQ(refusal("a.json", "[]"), ": holds no stroke.");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nl 1\n"), ":2: a line takes two vertices or more.");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nl 1 2\n"), ":2: \"2\" is no vertex of the file so far.");
  EXPECT_EQ(refusal("a.csv", "7,0 0 0\n"),
            ":1: \"7,0 0 0\" has commas that may be decimal or part numbers, or are not what they "
            "are in lines before; write decimal points.");
  EXPECT_EQ(refusal("a.csv", "s1,0 0 0\n"),
            ":1: \"s1\" is no coordinate: a point takes x, y and z.");
  EXPECT_EQ(refusal("a.csv", "1,2,x\n"), ":1: \"x\" is no coordinate: a point takes x, y and z.");
}

}  // namespace
}  // namespace bodyline
