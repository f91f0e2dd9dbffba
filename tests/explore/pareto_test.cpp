#include "explore/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "explore/philox.hpp"

namespace bodyline::explore {
namespace {

using ::testing::ElementsAre;

bool dominates(const double* p, const double* q, int m) {
  bool better = false;
  for (int k = 0; k < m; ++k) {
    if (p[k] > q[k]) return false;
    better |= p[k] < q[k];
  }
  return better;
}

TEST(ParetoSet, HoldsExactlyThePointsThatNoneDominates) {
  const PlacedRandom random(9, 99);
  for (const int m : {2, 3, 5}) {
    std::vector<double> values;
    constexpr std::size_t count = 300;
    for (std::uint64_t k = 0; k < count; ++k) {
      // Few different numbers, so that some are equal.
      for (int o = 0; o < m; ++o)
        values.push_back(std::floor(8.0 * random.uniform(k, std::uint32_t(o))[0]));
    }
    const std::vector<std::size_t> front = pareto_set(values, m);
    for (std::size_t k = 0; k < count; ++k) {
      bool dominated = false;
      for (std::size_t j = 0; j < count; ++j)
        dominated |= dominates(&values[j * std::size_t(m)], &values[k * std::size_t(m)], m);
      EXPECT_EQ(std::binary_search(front.begin(), front.end(), k), !dominated);
    }
  }
}

TEST(ParetoSet, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(pareto_set(std::vector<double>{nan, 0.0, 1.0, 2.0, 2.0, 1.0, 2.0, 2.0}, 2),
              ElementsAre(1, 2));
}

}  // namespace
}  // namespace bodyline::explore
