#include "strokes/points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bodyline::strokes {
namespace {

Points on_axis(const std::vector<double>& xs) {
  Points points;
  for (const double x : xs) points.emplace_back(x, 0.0, 0.0);
  return points;
}

TEST(Filtered, KeepsPointsAtLeastTheThresholdApart) {
  EXPECT_EQ(filtered(on_axis({0, 0.4, 1.0, 1.5, 2.5, 4.0}), 1.0), on_axis({0, 1.0, 2.5, 4.0}));
}

TEST(Filtered, TheLastPointReplacesOneThatIsTooNear) {
  EXPECT_EQ(filtered(on_axis({0, 1.0, 2.0, 2.3}), 1.0), on_axis({0, 1.0, 2.3}));
}

TEST(Filtered, AStrokeSmallerThanTheThresholdIsAPoint) {
  EXPECT_EQ(filtered(on_axis({0, 0.2, 0.5}), 1.0).size(), 1u);
}

TEST(Equalise, InsertsMiddlesOfTheLongestChord) {
  Points few = on_axis({0, 4, 5}), many = on_axis({0, 1, 2, 3, 4});
  equalise(few, many);
  EXPECT_EQ(few, on_axis({0, 1, 2, 4, 5}));
  EXPECT_EQ(many.size(), 5u);
}

TEST(Equalise, TheFirstOfEqualChordsIsCut) {
  Points few = on_axis({0, 2, 4}), many = on_axis({0, 1, 2, 3});
  equalise(many, few);
  EXPECT_EQ(few, on_axis({0, 1, 2, 4}));
}

TEST(ChordParameters, AreLengthsFromTheFirstPoint) {
  EXPECT_EQ(chord_parameters(on_axis({0, 1, 4})), (std::vector<double>{0.0, 0.25, 1.0}));
}

TEST(ChordParameters, AreRefusedWithoutLength) {
  EXPECT_THROW(chord_parameters(on_axis({2, 2})), std::invalid_argument);
}

TEST(Larger, KeepsWhatCannotBeMeasured) {
  EXPECT_EQ(larger(1.0, 2.0), 2.0);
  EXPECT_EQ(larger(2.0, 1.0), 2.0);
  EXPECT_TRUE(std::isnan(larger(std::nan(""), 1.0)));
  EXPECT_TRUE(std::isnan(larger(1.0, std::nan(""))));
}

}  // namespace
}  // namespace bodyline::strokes
