#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/input_error.hpp"
#include "io/read_hard_points.hpp"
#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

// Each test has a folder of its own: they run side by side.
class HardPoints : public testing::ScanFiles {
 protected:
  std::vector<model::HardPoint> read(const std::string& text) const {
    return io::read_hard_points(file("points.csv", text));
  }
};

TEST_F(HardPoints, MayHaveDecimalCommas) {
  const auto points = read("2000,5;-500;1000,25;inside;20,5\n");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].point, Eigen::Vector3d(2000.5, -500.0, 1000.25));
  EXPECT_EQ(points[0].margin, 20.5);
}

TEST_F(HardPoints, AreRefusedWhereCommasAreUnclear) {
  EXPECT_THROW(read("12,34 5 inside\n"), io::InputError);
  EXPECT_THROW(read("1,2,3,inside\n2000,5 -500 1000,25 inside\n"), io::InputError);
}

TEST_F(HardPoints, OneLineOfWordsMayStandAboveThem) {
  EXPECT_EQ(read("# package\nx_mm,y_mm,z_mm,rule,margin_mm\n1,2,3,inside,4\n").size(), 1u);
  EXPECT_THROW(read("x,y,z,rule\nx,y,z,rule\n1,2,3,inside\n"), io::InputError);
  EXPECT_THROW(read("1,2,3,inside\nx,y,z,rule\n"), io::InputError);
  EXPECT_THROW(read("x,2,3,inside\n"), io::InputError);
}

}  // namespace
}  // namespace bodyline
