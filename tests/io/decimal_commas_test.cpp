#include "io/decimal_commas.hpp"

#include <gtest/gtest.h>

namespace bodyline {
namespace {

using io::DecimalCommas;
using io::LineNumbers;

constexpr LineNumbers points{3, false}, named_points{3, true}, named_pairs{2, true};

// What becomes of a line of a file, after lines before it; "unclear" where that is refused.
std::string read(std::string_view line, const LineNumbers& numbers = points,
                 const std::vector<std::string>& before = {}) {
  DecimalCommas commas(numbers);
  for (const std::string& other : before) EXPECT_TRUE(commas.with_points(other)) << other;
  return std::string(commas.with_points(line).value_or("unclear"));
}

TEST(DecimalCommas, BecomePointsWhereSomethingElsePartsNumbers) {
  EXPECT_EQ(read("1,5 2,3 0,4"), "1.5 2.3 0.4");
  EXPECT_EQ(read("1,5;2,3;0,4"), "1.5;2.3;0.4");
  EXPECT_EQ(read("-1,5\t2\t3"), "-1.5\t2\t3");
  EXPECT_EQ(read("2000,5 -500 1000 inside 20,25"), "2000.5 -500 1000 inside 20.25");
  EXPECT_EQ(read("1,5e3 2,3E-1 0"), "1.5e3 2.3E-1 0");
}

TEST(DecimalCommas, AreNoneWhereCommasPartNumbers) {
  for (const char* line :
       {"1,2,3", "1.5,2.3,0.4", "1, 2, 3", "1 ,2 ,3", "1,2,3 0,0,1", "2000,-300,900 inside 20",
        "1.5;2.3;0.4", "1.5 2.5 roof,left", "100,200 roof", "2000, -300, 900, inside, 20", ",1 2",
        "1,,2 3", "", ",", "1 2 3"})
    EXPECT_EQ(read(line), line);
}

TEST(DecimalCommas, AreNoneInNames) {
  EXPECT_EQ(read("s1,0 0 0", named_points), "s1,0 0 0");
  EXPECT_EQ(read("s1,0 0,5 0,5 1,5", named_points), "s1,0 0.5 0.5 1.5");
  EXPECT_EQ(read("1,5 2,3 roof,left", named_pairs), "1.5 2.3 roof,left");
}

TEST(DecimalCommas, AreUnclearWhereALineIsAPointBothWays) {
  EXPECT_EQ(read("100,2 7", named_pairs), "unclear");   // or 100 2, called 7
  EXPECT_EQ(read("7,0 0 0", named_points), "unclear");  // or 0 0 0 of the stroke 7
  EXPECT_EQ(read("12,34 5"), "unclear");                // or a number is missing
  EXPECT_EQ(read("1,5 2,5 0.5"), "unclear");
}

TEST(DecimalCommas, AreWhatTheyWereBefore) {
  EXPECT_EQ(read("100,2 7", named_pairs, {"100,5 7,25"}), "100.2 7");
  EXPECT_EQ(read("100,2 7", named_pairs, {"1 2", "100,2 roof"}), "100,2 7");
  EXPECT_EQ(read("7,0 0 0", named_points, {"1;0,5;0"}), "7.0 0 0");
  EXPECT_EQ(read("12,34 5", points, {"1,5 2,3 0,4"}), "12.34 5");
}

TEST(DecimalCommas, AreRefusedWhereTheyChangeWithinAFile) {
  EXPECT_EQ(read("1,2,3", points, {"1,5 2,3 0,4"}), "unclear");
  EXPECT_EQ(read("1, 2, 3", points, {"1,5 2,3 0,4"}), "unclear");
  EXPECT_EQ(read("1,5 2,3 0,4", points, {"1,2,3"}), "unclear");
}

TEST(DecimalCommas, OfLinesThatAreNoPointsTellNothing) {
  EXPECT_EQ(read("1,2,3", points, {"scale 0,5", "x,y,z", "roof,left"}), "1,2,3");
  EXPECT_EQ(read("1,5 2,3 0,4", points, {"scale 0,5", "x,y,z"}), "1.5 2.3 0.4");
  EXPECT_EQ(read("1,5 2,3", named_pairs, {"scale 0,5"}), "1.5 2.3");
}

}  // namespace
}  // namespace bodyline
