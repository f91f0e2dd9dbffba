#include <gtest/gtest.h>

#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

class EveryAlgorithmLimit : public testing::TestWithParam<Algorithm> {};
INSTANTIATE_TEST_SUITE_P(, EveryAlgorithmLimit, testing::ValuesIn(all_algorithms()),
                         [](const auto& test) { return test_name(test.param); });

TestProblem bounded_rosenbrock() {
  TestProblem problem = rosenbrock(10);
  problem.within(-5, 5);
  return problem;
}

const VectorXd start = VectorXd::Constant(10, -1.2);

TEST_P(EveryAlgorithmLimit, InterruptStopsAtOnce) {
  TestProblem problem = bounded_rosenbrock();
  Options options = options_for(GetParam());
  int polls = 0, calls_when_stopped = 0;
  options.should_stop = [&] {
    if (++polls == 12) calls_when_stopped = problem.calls;
    return polls >= 12;
  };
  const Result result = minimize(problem, start, options);
  EXPECT_EQ(result.status, Status::interrupted);
  // Nothing more than the check of the result.
  EXPECT_LE(problem.calls, calls_when_stopped + 2);
  EXPECT_LE(result.value, result.start_value);
}

TEST_P(EveryAlgorithmLimit, InterruptFromTheBeginningGivesTheStart) {
  TestProblem problem = bounded_rosenbrock();
  Options options = options_for(GetParam());
  options.restarts = 3;
  options.should_stop = [] { return true; };
  const Result result = minimize(problem, start, options);
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.x, start);
  EXPECT_EQ(result.value, result.start_value);
}

TEST_P(EveryAlgorithmLimit, EvaluationLimitIsKept) {
  for (const int limit : {1, 2, 7, 30}) {
    TestProblem problem = bounded_rosenbrock();
    Options options = options_for(GetParam());
    options.max_evaluations = limit;
    const Result result = minimize(problem, start, options);
    EXPECT_EQ(result.status, Status::evaluation_limit);
    EXPECT_LE(problem.calls, limit + 2);  // the check of the result
    EXPECT_EQ(result.evaluations, problem.calls);
  }
}

TEST_P(EveryAlgorithmLimit, TimeLimitIsKept) {
  TestProblem problem = bounded_rosenbrock();
  Options options = options_for(GetParam());
  options.max_seconds = 1e-9;
  options.restarts = 2;
  const Result result = minimize(problem, start, options);
  EXPECT_EQ(result.status, Status::time_limit);
  EXPECT_EQ(result.x, start);
}

TEST_P(EveryAlgorithmLimit, HistoryFallsToTheResult) {
  TestProblem problem = bounded_rosenbrock();
  Options options = options_for(GetParam());
  std::vector<Progress> seen;
  options.on_progress = [&](const Progress& progress) { seen.push_back(progress); };
  const Result result = minimize(problem, start, options);
  ASSERT_FALSE(result.history.empty());
  ASSERT_EQ(seen.size(), result.history.size());
  EXPECT_EQ(result.history.front().value, result.start_value);
  EXPECT_EQ(result.history.front().evaluation, 1);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_LT(result.history[i].value, result.history[i - 1].value);
    EXPECT_GT(result.history[i].evaluation, result.history[i - 1].evaluation);
    EXPECT_EQ(seen[i].value, result.history[i].value);
  }
  // Levenberg-Marquardt reports sums of squares, which may round differently than the value.
  EXPECT_NEAR(result.history.back().value, result.value, 1e-14 * result.start_value);
}

TEST_P(EveryAlgorithmLimit, SameSeedGivesTheSameBits) {
  Options options = options_for(GetParam());
  options.restarts = 1;
  options.max_evaluations = 500;
  TestProblem first = bounded_rosenbrock(), second = bounded_rosenbrock();
  const Result a = minimize(first, start, options), b = minimize(second, start, options);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.status, b.status);
}

TEST_P(EveryAlgorithmLimit, SaysNothingOnStandardError) {
  testing::internal::CaptureStderr();
  TestProblem problem = bounded_rosenbrock();
  minimize(problem, start, options_for(GetParam()));
  TestProblem kinked = absolute_values(VectorXd::Zero(2));
  kinked.within(-1, 1);
  if (GetParam() != Algorithm::ceres_lm) {
    minimize(kinked, VectorXd::Constant(2, 0.7), options_for(GetParam()));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace bodyline::optimize
