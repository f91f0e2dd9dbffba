#include "explore/evolution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "explore/hypervolume.hpp"
#include "explore/sampler_sobol.hpp"

namespace bodyline::testing {
namespace {

using explore::EvolutionOptions;
using explore::Population;

// ZDT1 of Zitzler, Deb and Thiele, 2000: its front is f2 = 1 - sqrt(f1), where all coordinates but
// the first are 0.
class Zdt1 : public explore::ObjectiveBatch {
 public:
  int dimension() const override { return 30; }
  int objectives() const override { return 2; }
  void evaluate(std::span<const double> points, std::span<double> values) override {
    ++batches;
    const std::size_t d = 30;
    for (std::size_t k = 0; k < points.size() / d; ++k) {
      double sum = 0.0;
      for (std::size_t i = 1; i < d; ++i) sum += points[k * d + i];
      const double g = 1.0 + 9.0 * sum / double(d - 1);
      values[2 * k] = points[k * d];
      values[2 * k + 1] = g * (1.0 - std::sqrt(points[k * d] / g));
    }
    evaluations += points.size() / d;
  }
  std::size_t batches = 0, evaluations = 0;
};

constexpr int population = 100, generations = 500;
// Mean height above the true front after 50,000 evaluations, of a front that is 1 high; random
// points are 4 above it.
constexpr double height_bound = 0.02;
// Of the front to (1.1, 1.1): 1.21 - 1/3. A hundred points fall short of it by some 0.005.
constexpr double true_volume = 1.21 - 1.0 / 3.0, volume_bound = 0.02;

using Evolve = Population (*)(explore::ObjectiveBatch&, const EvolutionOptions&);

EvolutionOptions options_of(std::uint32_t seed, int count = generations) {
  EvolutionOptions options;
  options.generations = count;
  options.seed = seed;
  options.first.resize(population * 30);
  explore::sobol_sampler(30, population, true, seed)->points(0, population, options.first);
  return options;
}

class Evolution : public ::testing::TestWithParam<Evolve> {};

TEST_P(Evolution, ComesToTheFrontOfZdt1) {
  Zdt1 zdt1;
  const Population last = GetParam()(zdt1, options_of(1));
  ASSERT_EQ(last.values.size(), 2u * population);
  double height = 0.0;
  for (std::size_t k = 0; k < population; ++k)
    height += last.values[2 * k + 1] - (1.0 - std::sqrt(last.values[2 * k]));
  EXPECT_LT(height / population, height_bound);
  const std::vector<double> reference{1.1, 1.1};
  EXPECT_GT(explore::hypervolume(last.values, reference), true_volume - volume_bound);
  EXPECT_LT(explore::hypervolume(last.values, reference), true_volume);
}

TEST_P(Evolution, EvaluatesManyAtOnce) {
  Zdt1 zdt1;
  GetParam()(zdt1, options_of(1, 7));
  // All of a generation, or 24.
  EXPECT_EQ(zdt1.batches, GetParam() == &explore::evolve_nsga2 ? 8u : 1u + 7u * 5u);
  EXPECT_EQ(zdt1.evaluations, 8u * population);
}

TEST_P(Evolution, FollowsFromItsSeed) {
  Zdt1 zdt1;
  EvolutionOptions options = options_of(1, 5);
  const std::vector<double> one = GetParam()(zdt1, options).points;
  EXPECT_EQ(one, GetParam()(zdt1, options).points);
  options.seed = 2;
  EXPECT_NE(one, GetParam()(zdt1, options).points);
}

TEST_P(Evolution, EndsBeforeAGenerationThatIsNotWanted) {
  Zdt1 zdt1;
  EvolutionOptions options = options_of(1);
  options.before = [](int generation) { return generation < 3; };
  GetParam()(zdt1, options);
  EXPECT_EQ(zdt1.evaluations, 3u * population);
}

INSTANTIATE_TEST_SUITE_P(Each, Evolution,
                         ::testing::Values(&explore::evolve_nsga2, &explore::evolve_moead),
                         [](const auto& test) { return test.index == 0 ? "Nsga2" : "Moead"; });

TEST(Hypervolume, IsTheAreaUnderStairs) {
  const std::vector<double> points{1, 3, 2, 2, 3, 1}, reference{4, 4};
  EXPECT_DOUBLE_EQ(explore::hypervolume(points, reference), 6.0);
}

TEST(Hypervolume, CountsOnlyWhatIsBetterThanTheReference) {
  const std::vector<double> points{1, 3, 4, 0, NAN, 1, 5, 0.5}, reference{4, 4};
  EXPECT_DOUBLE_EQ(explore::hypervolume(points, reference), 3.0);
  EXPECT_EQ(explore::hypervolume({}, reference), 0.0);
}

TEST(Hypervolume, OfThreeObjectivesIsABox) {
  const std::vector<double> points{1, 2, 3}, reference{2, 4, 6};
  EXPECT_DOUBLE_EQ(explore::hypervolume(points, reference), 6.0);
}

}  // namespace
}  // namespace bodyline::testing
