// Samplers whose points are a design: grids, one at a time, and those of sensitivities.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "explore/sampler_grid.hpp"
#include "explore/sampler_sensitivity.hpp"
#include "explore/sampler_sobol.hpp"
#include "sampler_points.hpp"

namespace bodyline::explore {
namespace {

using testing::all_points;
using testing::coordinate;
using ::testing::ElementsAre;

constexpr std::uint64_t seed = 7;

TEST(Factorial, TakesEveryCombinationOnce) {
  const auto sampler = factorial_sampler({{0.0, 0.5, 1.0}, {0.0, 1.0}, {0.25, 0.5, 0.75, 1.0}});
  EXPECT_EQ(sampler->size(), 24u);
  const auto rows = all_points(*sampler);
  std::set<std::vector<double>> different;
  for (std::size_t row = 0; row < 24; ++row)
    different.insert(
        {rows.begin() + std::ptrdiff_t(3 * row), rows.begin() + std::ptrdiff_t(3 * row + 3)});
  EXPECT_EQ(different.size(), 24u);
  EXPECT_THAT(std::vector<double>(rows.begin(), rows.begin() + 6),
              ElementsAre(0.0, 0.0, 0.25, 0.0, 0.0, 0.5));
}

TEST(Factorial, RefusesMoreThanCanBeCounted) {
  EXPECT_THROW(factorial_sampler(Levels(100, {0.0, 1.0})), std::invalid_argument);
}

TEST(OneAtATime, MovesOneCoordinateAwayFromTheBase) {
  const std::vector<double> base{0.3, 0.6};
  const auto sampler = one_at_a_time_sampler(base, {{0.0, 1.0}, {0.0, 0.5, 1.0}});
  EXPECT_THAT(all_points(*sampler),
              ElementsAre(0.3, 0.6, 0.0, 0.6, 1.0, 0.6, 0.3, 0.0, 0.3, 0.5, 0.3, 1.0));
}

TEST(Morris, TrajectoriesMoveEveryCoordinateOnce) {
  constexpr int dimension = 6, trajectories = 20, levels = 4;
  const double step = levels / (2.0 * (levels - 1));
  const auto rows = all_points(*morris_sampler(dimension, trajectories, levels, seed));
  ASSERT_EQ(rows.size(), std::size_t(trajectories * morris_rows(dimension) * dimension));
  for (int t = 0; t < trajectories; ++t) {
    std::set<int> moved;
    for (int n = 0; n < dimension; ++n) {
      const std::size_t row = std::size_t(t * morris_rows(dimension) + n);
      for (int k = 0; k < dimension; ++k) {
        const double change =
            coordinate(rows, dimension, row + 1, k) - coordinate(rows, dimension, row, k);
        if (change == 0.0) continue;
        EXPECT_NEAR(std::abs(change), step, 1e-15);
        EXPECT_TRUE(moved.insert(k).second);
      }
      EXPECT_EQ(moved.size(), std::size_t(n + 1));
    }
  }
}

TEST(Morris, StaysOnItsGrid) {
  constexpr int dimension = 6, levels = 6;
  std::set<long> seen;
  for (const double x : all_points(*morris_sampler(dimension, 50, levels, seed))) {
    const double level = x * (levels - 1);
    EXPECT_NEAR(level, std::round(level), 1e-12);
    seen.insert(std::lround(level));
  }
  EXPECT_THAT(seen, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Saltelli, ExchangesOneCoordinateOfBothHalves) {
  constexpr int dimension = 3, count = 16;
  const auto pairs = all_points(*sobol_sampler(2 * dimension, count, true, seed));
  for (const bool second_order : {false, true}) {
    const auto rows = all_points(*saltelli_sampler(dimension, count, second_order, true, seed));
    const int length = saltelli_rows(dimension, second_order);
    ASSERT_EQ(rows.size(), std::size_t(count * length * dimension));
    for (int n = 0; n < count; ++n) {
      const auto half = [&](int which, int k) {
        return coordinate(pairs, 2 * dimension, std::size_t(n), which * dimension + k);
      };
      for (int place = 0; place < length; ++place) {
        const int exchanged = place == 0 || place + 1 == length ? -1 : (place - 1) % dimension;
        const int mostly = place <= dimension && place + 1 != length ? 0 : 1;
        for (int k = 0; k < dimension; ++k) {
          EXPECT_EQ(coordinate(rows, dimension, std::size_t(n * length + place), k),
                    half(k == exchanged ? 1 - mostly : mostly, k));
        }
      }
    }
  }
}

}  // namespace
}  // namespace bodyline::explore
