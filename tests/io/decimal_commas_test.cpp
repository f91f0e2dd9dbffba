#include "io/decimal_commas.hpp"

#include <gtest/gtest.h>

namespace bodyline {
namespace {

std::string read(std::string_view line) {
  std::string buffer;
  return std::string(io::with_decimal_points(line, buffer));
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

}  // namespace
}  // namespace bodyline
