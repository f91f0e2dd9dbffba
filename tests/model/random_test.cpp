#include "model/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bodyline::model {
namespace {

constexpr int draws = 200'000;
constexpr double deviations = 5.0;  // of what chance may do

TEST(Random, UniformNumbersAreThoseOfTheEngine) {
  // The C++ standard gives the 10000th number of the engine seeded with 5489.
  Random random(5489);
  for (int k = 1; k < 10000; ++k) random.uniform();
  EXPECT_EQ(random.uniform(), std::ldexp(double(9981545732273789042ULL >> 11), -53));
}

TEST(Random, NormalNumbersHaveTheMomentsOfTheNormalDistribution) {
  Random random(11);
  std::array<double, 5> sums{};
  for (int k = 0; k < draws; ++k) {
    const double x = random.normal();
    for (int power = 1; power <= 4; ++power) sums[power] += std::pow(x, power);
  }
  // Variances of x, x^2, x^3 and x^4: 1, 2, 15 and 96.
  const auto bound = [](double variance) { return deviations * std::sqrt(variance / draws); };
  EXPECT_NEAR(sums[1] / draws, 0.0, bound(1));
  EXPECT_NEAR(sums[2] / draws, 1.0, bound(2));
  EXPECT_NEAR(sums[3] / draws, 0.0, bound(15));
  EXPECT_NEAR(sums[4] / draws, 3.0, bound(96));
}

TEST(Random, NormalNumbersFollowTheErrorFunction) {
  Random random(12);
  constexpr std::array<double, 7> limits{-3, -1.5, -1, -0.3, 0.5, 1, 2};
  std::array<int, 7> below{};
  for (int k = 0; k < draws; ++k) {
    const double x = random.normal();
    for (std::size_t l = 0; l < limits.size(); ++l) below[l] += x < limits[l];
  }
  for (std::size_t l = 0; l < limits.size(); ++l) {
    const double part = 0.5 * std::erfc(-limits[l] / std::sqrt(2.0));
    EXPECT_NEAR(below[l], draws * part, deviations * std::sqrt(draws * part * (1 - part)))
        << limits[l];
  }
}

TEST(Random, DirectionsAreUniformOnTheSphere) {
  Random random(13);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int k = 0; k < draws; ++k) {
    const Eigen::Vector3d direction = random.direction();
    ASSERT_NEAR(direction.norm(), 1.0, 1e-15);
    sum += direction;
    squares += direction * direction.transpose();
  }
  // A coordinate has the variance 1/3; its square, and products of two, at most 4/45.
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), deviations * std::sqrt(draws / 3.0));
  EXPECT_LT((squares - draws / 3.0 * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
            deviations * std::sqrt(draws * 4.0 / 45.0));
}

TEST(Random, WholeNumbersAreBelowTheirCountAndReachEachAlike) {
  Random random(14);
  std::array<int, 7> counts{};
  for (int k = 0; k < draws; ++k) ++counts.at(random.below(counts.size()));
  for (const int count : counts) {
    EXPECT_NEAR(count, draws / 7.0, deviations * std::sqrt(draws * 6.0 / 49.0));
  }
}

}  // namespace
}  // namespace bodyline::model
