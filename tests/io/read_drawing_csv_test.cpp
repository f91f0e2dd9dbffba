#include "tests/io/drawing_support.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;

class CsvDrawing : public testing::DrawingFiles {};

TEST_F(CsvDrawing, IsALineFromPointToPoint) {
  const auto drawing = read("a.csv", "0,0\n3,0\n3,6\n");
  ASSERT_EQ(drawing.paths.size(), 1U);
  ASSERT_EQ(drawing.paths[0].segments.size(), 2U);
  EXPECT_EQ(drawing.paths[0].segments[1].points[0], Vector2d(3, 0));
  EXPECT_EQ(drawing.paths[0].segments[1].points[1], Vector2d(3, 2));
  EXPECT_EQ(drawing.paths[0].segments[1].points[3], Vector2d(3, 6));
  EXPECT_FALSE(drawing.paths[0].closed);
  EXPECT_FALSE(drawing.y_down);
}

TEST_F(CsvDrawing, TakesAnySeparator) {
  for (const char* text :
       {"0,1\n2,3\n", "0;1\n2;3\n", "0 1\n2 3\n", "0\t1\r\n2\t3\r\n", "0, 1\n2, 3"})
    EXPECT_EQ(read("a.txt", text).paths.at(0).segments.at(0).points[3], Vector2d(2, 3)) << text;
}

TEST_F(CsvDrawing, TakesDecimalCommas) {
  for (const char* text : {"0,5 1,5\n2,5 3,5\n", "0,5;1,5\n2,5;3,5\n"})
    EXPECT_EQ(read("a.csv", text).paths.at(0).segments.at(0).points[3], Vector2d(2.5, 3.5)) << text;
  EXPECT_EQ(read("a.csv", "0,5;1\n2;3,5\n").paths.at(0).segments.at(0).points[3], Vector2d(2, 3.5));
}

TEST_F(CsvDrawing, ACommaThatMayBeDecimalOrNotIsRefused) {
  EXPECT_THROW(read("a.csv", "100,2 7\n100,3 7\n"), io::InputError);
  EXPECT_THROW(read("a.csv", "1,2\n100,5 7,5\n"), io::InputError);
}

TEST_F(CsvDrawing, ACommaIsWhatItWasInLinesBefore) {
  EXPECT_EQ(read("a.csv", "0,5 1,5\n2,5 3\n").paths.at(0).segments.at(0).points[3],
            Vector2d(2.5, 3));
  const auto named = read("a.csv", "0,1 roof\n2,3 roof\n4,5 7\n6,7 7\n");
  ASSERT_EQ(named.paths.size(), 2U);
  EXPECT_EQ(named.paths[1].name, "7");
}

TEST_F(CsvDrawing, BeginsALineAtABlankOneAndAtAnotherName) {
  const auto drawing = read("a.csv",
                            "x,y,name\n0,0,roof\n1,0,roof\n1,1,\"the sill\"\n2,1,\"the sill\"\n"
                            "\n5,5\n# in between\n6,6\n \n\n0,0,roof\n1,0,roof\n");
  ASSERT_EQ(drawing.paths.size(), 4U);
  EXPECT_EQ(drawing.paths[0].name, "roof");
  EXPECT_EQ(drawing.paths[1].name, "the sill");
  EXPECT_EQ(drawing.paths[2].name, "");
  EXPECT_EQ(drawing.paths[2].segments.size(), 1U);
  EXPECT_EQ(drawing.paths[3].name, "roof");
}

TEST_F(CsvDrawing, IsClosedWhenItEndsWhereItBegins) {
  EXPECT_TRUE(read("a.csv", "0,0\n3,0\n3,6\n0,0\n").paths[0].closed);
  EXPECT_FALSE(read("a.csv", "0,0\n3,0\n0,0\n").paths[0].closed);
}

TEST_F(CsvDrawing, PassesOverRepeatedPointsAndTheMarkOfUtf8) {
  const auto drawing = read("a.csv",
                            "\xef\xbb\xbf"
                            "1,2\n1,2\n2,2\n");
  ASSERT_EQ(drawing.paths[0].segments.size(), 1U);
  EXPECT_EQ(drawing.paths[0].segments[0].points[0], Vector2d(1, 2));
}

}  // namespace
}  // namespace bodyline
