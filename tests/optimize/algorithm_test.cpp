#include "optimize/algorithm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "optimize/status.hpp"

namespace bodyline::optimize {
namespace {

TEST(AlgorithmName, NamesAndAlgorithmsCorrespond) {
  const std::vector<std::string> names = algorithm_names();
  EXPECT_THAT(names, testing::ElementsAre("nlopt-lbfgs", "nlopt-mma", "nlopt-ccsaq", "nlopt-slsqp",
                                          "nlopt-cobyla", "nlopt-crs", "nlopt-direct",
                                          "ceres-lbfgs", "ceres-lm"));
  for (const std::string& name : names) {
    EXPECT_EQ(algorithm_name(algorithm_from_name(name)), name);
  }
}

TEST(AlgorithmName, UnknownNameIsRefusedWithTheKnownOnes) {
  try {
    algorithm_from_name("newton");
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("newton"));
    for (const std::string& name : algorithm_names()) {
      EXPECT_THAT(error.what(), testing::HasSubstr(name));
    }
  }
}

TEST(StatusWords, EveryStatusHasItsOwnSentence) {
  std::vector<std::string> sentences;
  for (const Status status :
       {Status::converged, Status::small_improvement, Status::evaluation_limit, Status::time_limit,
        Status::interrupted, Status::no_progress, Status::failed}) {
    const std::string words = status_words(status);
    EXPECT_THAT(words, testing::EndsWith("."));
    EXPECT_THAT(sentences, testing::Not(testing::Contains(words)));
    sentences.push_back(words);
  }
}

}  // namespace
}  // namespace bodyline::optimize
