// When a search for a fairer chain goes on from where it ended (docs/families.md, section 5).

#include "optimize/chain_tuning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bodyline::testing {
namespace {

using optimize::Status;

constexpr int most_searches = 11;  // the first one and ten repeats

/// x^8 of one number: each search ends where it is tiny by what it started from, far from 0.
class Flat : public optimize::ChainObjective {
 public:
  Flat()
      : ChainObjective({{"shape.a", model::ChainKind::shape, {0}, -2.0, 2.0, false}},
                       Eigen::VectorXd::Ones(1), 1.0) {}

  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override {
    ++evaluations;
    measure_ = broken ? NAN : std::pow(x[0], 8);
    if (gradient) *gradient = Eigen::VectorXd::Constant(1, broken ? NAN : 8.0 * std::pow(x[0], 7));
    return measure_;
  }
  double measure() const override { return measure_; }

  int evaluations = 0;
  bool broken = false;

 private:
  double measure_ = 0.0;
};

/// Calls `begins` for each search behind the first: its evaluations are counted anew.
optimize::Options watched(const std::function<void()>& begins) {
  optimize::Options options;
  options.on_progress = [begins, last = 0](const optimize::Progress& progress) mutable {
    if (progress.evaluation <= last) begins();
    last = progress.evaluation;
  };
  return options;
}

TEST(ChainTuning, GoesOnSoManyTimesAtMost) {
  Flat problem;
  int searches = 1;
  optimize::tune(problem, watched([&] { ++searches; }));
  EXPECT_GT(searches, 1);
  EXPECT_LE(searches, most_searches);
}

TEST(ChainTuning, KeepsItsLimitHoweverOftenItGoesOn) {
  Flat problem;
  int searches = 1;
  optimize::Options options = watched([&] { ++searches; });
  optimize::tune(problem, options);
  const int unlimited = problem.evaluations;
  for (const int limit : {unlimited / 4, unlimited / 2}) {
    Flat limited;
    searches = 1;
    options.max_evaluations = limit;
    const optimize::ChainTuning tuning = optimize::tune(limited, options);
    EXPECT_GT(searches, 1) << limit;
    EXPECT_LE(tuning.evaluations, limit + searches) << limit;  // each may check its result
  }
}

TEST(ChainTuning, ThatCannotGoOnIsAsGoodAsBefore) {
  Flat problem;
  const optimize::ChainTuning tuning =
      optimize::tune(problem, watched([&] { problem.broken = true; }));
  ASSERT_TRUE(problem.broken);
  EXPECT_TRUE(tuning.status == Status::converged || tuning.status == Status::small_improvement)
      << optimize::status_words(tuning.status);
  EXPECT_LT(std::abs(tuning.end_values[0]), 0.6);  // a hundredth of the value, as it went on
  EXPECT_TRUE(std::isfinite(tuning.gradient_norm));
}

}  // namespace
}  // namespace bodyline::testing
