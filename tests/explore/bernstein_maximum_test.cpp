#include "explore/bernstein_maximum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "explore/philox.hpp"
#include "model/measures_extreme.hpp"

namespace bodyline::explore {
namespace {

constexpr double accuracy = 2e-7;  // twice what is promised: the search is no better

double value(const BernsteinPatch& patch, double u, double v) {
  const model::BernsteinJet in_u = model::bernstein(patch.degree_u, u),
                            in_v = model::bernstein(patch.degree_v, v);
  double sum = 0.0;
  for (int i = 0; i <= patch.degree_u; ++i) {
    for (int j = 0; j <= patch.degree_v; ++j)
      sum += in_u.d[0][i] * in_v.d[0][j] * patch.c[i * (patch.degree_v + 1) + j];
  }
  return sum;
}

BernsteinPatch random_patch(const PlacedRandom& random, std::uint64_t n) {
  const auto draw = random.uniform(n, 0);
  BernsteinPatch patch;
  patch.degree_u = 1 + int(draw[0] * 6);
  patch.degree_v = 1 + int(draw[1] * 6);
  for (int k = 0; k < (patch.degree_u + 1) * (patch.degree_v + 1); ++k)
    patch.c[k] = random.uniform(n, std::uint32_t(k + 1))[0];
  return patch;
}

TEST(BernsteinMaximum, IsThatOfASearch) {
  const PlacedRandom random(5, 99);
  for (std::uint64_t n = 0; n < 200; ++n) {
    const BernsteinPatch patch = random_patch(random, n);
    const double found = maximum(patch, -1e9);
    const model::Extreme searched =
        model::largest_value([&](double u, double v) { return value(patch, u, v); }, 40);
    EXPECT_NEAR(found, searched.value, accuracy) << n;
  }
}

TEST(BernsteinMaximum, KeepsALargerValueThatIsKnown) {
  const PlacedRandom random(6, 99);
  const BernsteinPatch patch = random_patch(random, 0);
  EXPECT_EQ(maximum(patch, 2.0), 2.0);
}

// x (1 - x) y (1 - y) has its maximum 1/16 in the middle; its Bernstein form of degree 2 has one
// coefficient that is not zero.
TEST(BernsteinMaximum, FindsAPeakInside) {
  BernsteinPatch patch{2, 2, {}};
  patch.c[4] = 0.25;
  EXPECT_NEAR(maximum(patch, -1.0), 1.0 / 16.0, accuracy);
}

// A ridge: all points with u = 1/2 are largest.
TEST(BernsteinMaximum, FindsARidge) {
  BernsteinPatch patch{2, 3, {}};
  for (int j = 0; j < 4; ++j) patch.c[4 + j] = 1.0;
  EXPECT_NEAR(maximum(patch, -1.0), 0.5, accuracy);
}

TEST(BernsteinMaximum, OfAConstantIsTheConstant) {
  BernsteinPatch patch{3, 3, {}};
  for (int k = 0; k < 16; ++k) patch.c[k] = -4.5;
  EXPECT_EQ(maximum(patch, -1e9), -4.5);
}

}  // namespace
}  // namespace bodyline::explore
