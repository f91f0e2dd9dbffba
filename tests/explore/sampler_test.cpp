#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <vector>

#include "explore/philox.hpp"
#include "explore/placed_permutation.hpp"
#include "explore/sampler_grid.hpp"
#include "explore/sampler_halton.hpp"
#include "explore/sampler_latin.hpp"
#include "explore/sampler_random.hpp"
#include "explore/sampler_sensitivity.hpp"
#include "explore/sampler_sobol.hpp"
#include "sampler_points.hpp"

namespace bodyline::explore {
namespace {

using ::testing::ElementsAre;

using testing::all_points;
using testing::coordinate;
using testing::counts;

constexpr std::uint64_t seed = 7;

TEST(Philox, GivesTheKnownAnswersOfItsAuthors) {
  EXPECT_THAT(philox({0, 0, 0, 0}, {0, 0}),
              ElementsAre(0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u));
  EXPECT_THAT(
      philox({0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu}, {0xffffffffu, 0xffffffffu}),
      ElementsAre(0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu));
  EXPECT_THAT(
      philox({0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u}, {0xa4093822u, 0x299f31d0u}),
      ElementsAre(0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u));
}

TEST(PlacedPermutation, TakesEveryPlaceOnce) {
  for (const std::uint64_t size : {1, 2, 3, 5, 64, 1000, 4097}) {
    const PlacedPermutation permutation(size, seed);
    std::set<std::uint64_t> seen;
    for (std::uint64_t place = 0; place < size; ++place) seen.insert(permutation(place));
    EXPECT_EQ(seen.size(), size);
    EXPECT_LT(*seen.rbegin(), size);
  }
}

TEST(PlacedPermutation, DependsOnItsKey) {
  constexpr std::uint64_t size = 1000;
  const PlacedPermutation a(size, 1), b(size, 2);
  int same = 0;
  for (std::uint64_t place = 0; place < size; ++place) same += a(place) == b(place);
  EXPECT_LT(same, 20);  // one is expected of two random permutations
}

TEST(Sobol, BeginsWithItsKnownPoints) {
  // The first points of the sequence of Joe and Kuo in three dimensions, in the order of Gray
  // codes.
  const auto points = all_points(*sobol_sampler(3, 8, false, 0));
  EXPECT_THAT(points, ElementsAre(0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.75, 0.25, 0.25, 0.25, 0.75, 0.75,
                                  0.375, 0.375, 0.625, 0.875, 0.875, 0.125, 0.625, 0.125, 0.875,
                                  0.125, 0.625, 0.375));
}

// Of the first 2^k points one lies in each interval of length 2^-k, in every dimension: the
// direction numbers have their leading ones. A digital shift or a nested scrambling keeps that.
TEST(Sobol, HasOnePointInEveryBinaryInterval) {
  constexpr int dimension = 500, count = 1024;
  for (const bool scrambled : {false, true}) {
    const auto rows = all_points(*sobol_sampler(dimension, count, scrambled, seed));
    for (int k = 0; k < dimension; ++k)
      EXPECT_THAT(counts(rows, dimension, k, count), ::testing::Each(1)) << "dimension " << k;
  }
}

// Two dimensions with one polynomial would be one sequence.
TEST(Sobol, HasDifferentDirectionsInEveryDimension) {
  constexpr int dimension = 500;
  const std::vector<std::uint32_t> directions = sobol_directions(dimension);
  std::set<std::vector<std::uint32_t>> different;
  for (int k = 0; k < dimension; ++k) {
    std::vector<std::uint32_t> own;
    for (int bit = 0; bit < 32; ++bit) own.push_back(directions[std::size_t(bit * dimension + k)]);
    different.insert(own);
  }
  EXPECT_EQ(different.size(), std::size_t(dimension));
}

// The first two dimensions are a (0, m, 2)-net: one point in each elementary interval of area 2^-m.
TEST(Sobol, IsANetInItsFirstTwoDimensionsAlsoWhenScrambled) {
  constexpr int m = 8;
  for (const bool scrambled : {false, true}) {
    const auto rows = all_points(*sobol_sampler(2, 1 << m, scrambled, seed));
    for (int along_x = 0; along_x <= m; ++along_x) {
      std::set<std::pair<int, int>> boxes;
      for (std::size_t row = 0; row < (1u << m); ++row)
        boxes.insert(
            {int(rows[2 * row] * (1 << along_x)), int(rows[2 * row + 1] * (1 << (m - along_x)))});
      EXPECT_EQ(boxes.size(), std::size_t(1 << m));
    }
  }
}

// Owen's scrambling: whether a bit is flipped depends on the bits above it alone.
TEST(Sobol, ScramblingKeepsCommonPrefixes) {
  const PlacedRandom random(seed, 99);
  for (std::uint64_t n = 0; n < 200; ++n) {
    const std::uint32_t x = std::uint32_t(random.bits(n, 0)[0]);
    for (int bit = 0; bit < 32; ++bit) {
      const std::uint32_t y = x ^ (0x80000000u >> bit);
      const std::uint32_t difference = nested_scramble(x, 5) ^ nested_scramble(y, 5);
      EXPECT_EQ(__builtin_clz(difference), bit);
    }
  }
}

TEST(Sobol, RefusesWhatItsDirectionNumbersDoNotReach) {
  EXPECT_THROW(sobol_sampler(3668, 1, true, seed), std::invalid_argument);
  EXPECT_THROW(sobol_sampler(2, most_sobol_points + 1, true, seed), std::invalid_argument);
}

TEST(Halton, BeginsWithItsKnownPoints) {
  const auto points = all_points(*halton_sampler(2, 6, false, 0));
  const std::vector<double> known{0.0,  0.0,       0.5,   1.0 / 3.0, 0.25,  2.0 / 3.0,
                                  0.75, 1.0 / 9.0, 0.125, 4.0 / 9.0, 0.625, 7.0 / 9.0};
  ASSERT_EQ(points.size(), known.size());
  for (std::size_t k = 0; k < known.size(); ++k) EXPECT_NEAR(points[k], known[k], 1e-15);
}

// Of the first b^2 points one lies in each interval of length b^-2 of the dimension with base b.
TEST(Halton, HasOnePointInEveryIntervalOfItsBases) {
  constexpr int dimension = 8;
  const int primes[dimension] = {2, 3, 5, 7, 11, 13, 17, 19};
  for (const bool scrambled : {false, true}) {
    for (int k = 0; k < dimension; ++k) {
      const int count = primes[k] * primes[k];
      auto rows = all_points(*halton_sampler(dimension, std::uint64_t(count), scrambled, seed));
      // Points of the plain sequence lie on the intervals' ends, up to rounding.
      for (double& x : rows) x += scrambled ? 0.0 : 1e-12;
      EXPECT_THAT(counts(rows, dimension, k, count), ::testing::Each(1)) << "base " << primes[k];
    }
  }
}

TEST(Latin, HasOnePointInEveryStratum) {
  constexpr int dimension = 5;
  for (const int count : {1, 2, 7, 1000}) {
    const auto rows = all_points(*latin_sampler(dimension, std::uint64_t(count), seed));
    for (int k = 0; k < dimension; ++k)
      EXPECT_THAT(counts(rows, dimension, k, count), ::testing::Each(1));
  }
}

TEST(Latin, MaximinKeepsTheStrata) {
  constexpr int dimension = 4, count = 60;
  const auto rows = all_points(*latin_maximin_sampler(dimension, count, seed));
  for (int k = 0; k < dimension; ++k)
    EXPECT_THAT(counts(rows, dimension, k, count), ::testing::Each(1));
}

double smallest_distance(const std::vector<double>& rows, int dimension) {
  const std::size_t count = rows.size() / std::size_t(dimension);
  double smallest = 1e9;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      double squared = 0.0;
      for (int k = 0; k < dimension; ++k)
        squared +=
            std::pow(coordinate(rows, dimension, a, k) - coordinate(rows, dimension, b, k), 2);
      smallest = std::min(smallest, std::sqrt(squared));
    }
  }
  return smallest;
}

TEST(Latin, MaximinMovesPointsApart) {
  constexpr int dimension = 4, count = 60;
  for (std::uint64_t s = 1; s <= 3; ++s) {
    const double plain =
        smallest_distance(all_points(*latin_sampler(dimension, count, s)), dimension);
    const double better =
        smallest_distance(all_points(*latin_maximin_sampler(dimension, count, s)), dimension);
    EXPECT_GT(better, 1.5 * plain);
  }
}

TEST(Latin, MaximinRefusesWhatItCannotKeepInMemory) {
  EXPECT_THROW(latin_maximin_sampler(3, most_maximin_points + 1, seed), std::invalid_argument);
}

TEST(Random, IsUniformInEveryDimension) {
  constexpr int dimension = 5, count = 20000, strata = 10;
  const auto rows = all_points(*random_sampler(dimension, count, seed));
  // Five standard deviations of the number of points in a tenth.
  const double allowed = 5.0 * std::sqrt(count * 0.1 * 0.9);
  for (int k = 0; k < dimension; ++k) {
    for (const int n : counts(rows, dimension, k, strata)) EXPECT_NEAR(n, count / strata, allowed);
  }
}

// Every step of a trajectory moves one coordinate by levels / (2 (levels - 1)), each once.
struct NamedSampler {
  const char* name;
  std::shared_ptr<Sampler> sampler;
};

std::vector<NamedSampler> all_samplers() {
  constexpr int d = 7;
  const Levels levels(std::size_t(d), {0.0, 1.0});
  std::vector<NamedSampler> list;
  const auto add = [&](const char* name, std::unique_ptr<Sampler> sampler) {
    list.push_back({name, std::move(sampler)});
  };
  add("sobol", sobol_sampler(d, 100, false, seed));
  add("scrambled_sobol", sobol_sampler(d, 100, true, seed));
  add("halton", halton_sampler(d, 100, false, seed));
  add("scrambled_halton", halton_sampler(d, 100, true, seed));
  add("latin", latin_sampler(d, 100, seed));
  add("latin_maximin", latin_maximin_sampler(d, 100, seed));
  add("random", random_sampler(d, 100, seed));
  add("factorial", factorial_sampler(levels));
  add("one_at_a_time", one_at_a_time_sampler(std::vector<double>(std::size_t(d), 0.5), levels));
  add("morris", morris_sampler(d, 10, 4, seed));
  add("saltelli", saltelli_sampler(d, 10, true, true, seed));
  return list;
}

class EverySampler : public ::testing::TestWithParam<NamedSampler> {};

TEST_P(EverySampler, GivesAPointTheSameWhereverOneBegins) {
  const Sampler& sampler = *GetParam().sampler;
  const int d = sampler.dimension();
  const auto whole = all_points(sampler);
  for (std::uint64_t first = 0; first < sampler.size(); first += 3) {
    const int count = int(std::min<std::uint64_t>(5, sampler.size() - first));
    std::vector<double> rows(std::size_t(count * d));
    sampler.points(first, count, rows);
    EXPECT_TRUE(std::equal(rows.begin(), rows.end(), whole.begin() + std::ptrdiff_t(first) * d));
  }
}

TEST_P(EverySampler, StaysInTheCube) {
  for (const double x : all_points(*GetParam().sampler)) {
    EXPECT_GE(x, 0.0);
    EXPECT_LE(x, 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, EverySampler, ::testing::ValuesIn(all_samplers()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Samplers, DependOnTheirSeeds) {
  EXPECT_NE(all_points(*sobol_sampler(3, 8, true, 1)), all_points(*sobol_sampler(3, 8, true, 2)));
  EXPECT_NE(all_points(*halton_sampler(3, 8, true, 1)), all_points(*halton_sampler(3, 8, true, 2)));
  EXPECT_NE(all_points(*latin_sampler(3, 8, 1)), all_points(*latin_sampler(3, 8, 2)));
  EXPECT_NE(all_points(*random_sampler(3, 8, 1)), all_points(*random_sampler(3, 8, 2)));
  EXPECT_NE(all_points(*morris_sampler(3, 2, 4, 1)), all_points(*morris_sampler(3, 2, 4, 2)));
}

}  // namespace
}  // namespace bodyline::explore
