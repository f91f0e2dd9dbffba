#include "explore/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "explore/sampler_sensitivity.hpp"

namespace bodyline::explore {
namespace {

constexpr int dimension = 3;
constexpr std::uint64_t seed = 3;
constexpr double a = 7.0, b = 0.1;

// Ishigami and Homma, "An importance quantification technique in uncertainty analysis for computer
// models", 1990: sin x + a sin^2 y + b z^4 sin x on [-pi, pi]^3.
double ishigami(const double* point) {
  const auto angle = [&](int k) { return std::numbers::pi * (2.0 * point[k] - 1.0); };
  return std::sin(angle(0)) + a * std::pow(std::sin(angle(1)), 2) +
         b * std::pow(angle(2), 4) * std::sin(angle(0));
}

std::vector<double> all_points(const Sampler& sampler) {
  std::vector<double> points(sampler.size() * std::uint64_t(dimension));
  sampler.points(0, int(sampler.size()), points);
  return points;
}

template <class Function>
std::vector<double> results_of(const std::vector<double>& points, const Function& f) {
  std::vector<double> results;
  for (std::size_t k = 0; k < points.size(); k += dimension) results.push_back(f(&points[k]));
  return results;
}

// Its indices in closed form.
struct Known {
  const double pi4 = std::pow(std::numbers::pi, 4);
  const double of_x = 0.5 * std::pow(1.0 + b * pi4 / 5.0, 2), of_y = a * a / 8.0;
  const double of_xz = b * b * pi4 * pi4 * (1.0 / 18.0 - 1.0 / 50.0);
  const double all = of_x + of_y + of_xz;
};

TEST(SobolIndices, AreThoseOfTheIshigamiFunction) {
  constexpr double sampling = 0.01;  // of 16384 points
  const auto points = all_points(*saltelli_sampler(dimension, 16384, true, true, seed));
  const SobolIndices found = sobol_indices(results_of(points, ishigami), dimension, true);
  const Known known;
  EXPECT_NEAR(found.first[0].value, known.of_x / known.all, sampling);
  EXPECT_NEAR(found.first[1].value, known.of_y / known.all, sampling);
  EXPECT_NEAR(found.first[2].value, 0.0, sampling);
  EXPECT_NEAR(found.total[0].value, (known.of_x + known.of_xz) / known.all, sampling);
  EXPECT_NEAR(found.total[1].value, known.of_y / known.all, sampling);
  EXPECT_NEAR(found.total[2].value, known.of_xz / known.all, sampling);
  EXPECT_NEAR(found.second[0 * dimension + 1].value, 0.0, 2.0 * sampling);
  EXPECT_NEAR(found.second[0 * dimension + 2].value, known.of_xz / known.all, 2.0 * sampling);
  EXPECT_NEAR(found.second[1 * dimension + 2].value, 0.0, 2.0 * sampling);
  EXPECT_EQ(found.used, 16384u);
}

TEST(SobolIndices, DoNotChangeWhenTheResultIsShiftedOrScaled) {
  const auto points = all_points(*saltelli_sampler(dimension, 512, false, true, seed));
  const auto plain = sobol_indices(results_of(points, ishigami), dimension, false);
  const auto other =
      sobol_indices(results_of(points, [](const double* p) { return 1e6 - 3.0 * ishigami(p); }),
                    dimension, false);
  for (std::size_t k = 0; k < dimension; ++k) {
    EXPECT_NEAR(plain.first[k].value, other.first[k].value, 1e-8);  // digits lost to 10^6
    EXPECT_NEAR(plain.total[k].value, other.total[k].value, 1e-8);
  }
}

TEST(SobolIndices, LeaveOutGroupsWithoutAResult) {
  const auto points = all_points(*saltelli_sampler(dimension, 4096, false, true, seed));
  std::vector<double> results = results_of(points, ishigami);
  for (std::size_t k = 0; k < results.size(); k += 997)
    results[k] = std::numeric_limits<double>::quiet_NaN();
  const SobolIndices found = sobol_indices(results, dimension, false);
  EXPECT_LT(found.used, found.all);
  EXPECT_EQ(found.all, 4096u);
  const Known known;
  EXPECT_NEAR(found.first[1].value, known.of_y / known.all, 0.03);
}

TEST(SobolIndices, IntervalsShrinkWithTheSquareRootOfTheNumber) {
  const auto width = [](std::uint64_t count) {
    const auto points = all_points(*saltelli_sampler(dimension, count, false, true, seed));
    return sobol_indices(results_of(points, ishigami), dimension, false).total[1].half_width;
  };
  EXPECT_NEAR(width(256) / width(4096), 4.0, 1.5);
}

// Of a linear function every elementary effect is its slope.
TEST(MorrisEffects, OfALinearFunctionAreItsSlopes) {
  const auto points = all_points(*morris_sampler(dimension, 10, 4, seed));
  const MorrisResult found = morris_effects(
      points, results_of(points, [](const double* p) { return 5.0 * p[0] - 2.0 * p[1] + 1.0; }),
      dimension);
  const double slopes[dimension] = {5.0, -2.0, 0.0};
  for (int k = 0; k < dimension; ++k) {
    EXPECT_NEAR(found.effects[k].mu, slopes[k], 1e-13);
    EXPECT_NEAR(found.effects[k].mu_star.value, std::abs(slopes[k]), 1e-13);
    EXPECT_NEAR(found.effects[k].sigma, 0.0, 1e-13);
    EXPECT_NEAR(found.effects[k].mu_star.half_width, 0.0, 1e-6);  // a root of rounding
  }
}

// x y: the effect of x is y, which is uniform on the levels.
TEST(MorrisEffects, OfAProductDependOnThePlace) {
  constexpr int levels = 4, trajectories = 4000;
  const auto points = all_points(*morris_sampler(dimension, trajectories, levels, seed));
  const MorrisResult found = morris_effects(
      points, results_of(points, [](const double* p) { return p[0] * p[1]; }), dimension);
  const double variance = (0.25 + 1.0 / 36.0) / 2.0 * 1.0;  // of 0, 1/3, 2/3, 1 about 1/2
  constexpr double sampling = 0.02;
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(found.effects[k].mu, 0.5, sampling);
    EXPECT_NEAR(found.effects[k].sigma, std::sqrt(variance), sampling);
  }
  EXPECT_EQ(found.effects[2].mu_star.value, 0.0);
}

TEST(MorrisEffects, MuStarCountsEffectsOfBothSigns) {
  const auto points = all_points(*morris_sampler(dimension, 2000, 4, seed));
  const MorrisResult found = morris_effects(
      points, results_of(points, [](const double* p) { return p[0] * (p[1] - 0.5); }), dimension);
  EXPECT_NEAR(found.effects[0].mu, 0.0, 0.03);
  EXPECT_NEAR(found.effects[0].mu_star.value, 1.0 / 3.0, 0.02);  // mean of 1/2, 1/6, 1/6, 1/2
}

}  // namespace
}  // namespace bodyline::explore
