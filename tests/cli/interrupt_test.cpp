#include "cli/interrupt.hpp"

#include <gtest/gtest.h>

namespace bodyline {
namespace {

TEST(Interrupt, TheFirstRequestIsRemembered) {
  const cli::Interrupt interrupt;
  EXPECT_FALSE(interrupt.requested());
  std::raise(SIGINT);
  EXPECT_TRUE(interrupt.requested());
}

TEST(Interrupt, WhatMpirunAndBatchSystemsSendIsARequestToo) {
  const cli::Interrupt interrupt;
  std::raise(SIGTERM);
  EXPECT_TRUE(interrupt.requested());
}

TEST(Interrupt, TheSecondRequestEndsTheProgram) {
  const auto ask_twice = [] {
    const cli::Interrupt interrupt;
    std::raise(SIGINT);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(ask_twice(), ::testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, EndsWithItsScope) {
  const auto ask_after = [] {
    { const cli::Interrupt interrupt; }
    std::raise(SIGINT);
  };
  EXPECT_EXIT(ask_after(), ::testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, ANewOneKnowsNothingOfOldRequests) {
  {
    const cli::Interrupt interrupt;
    std::raise(SIGINT);
  }
  EXPECT_FALSE(cli::Interrupt().requested());
}

}  // namespace
}  // namespace bodyline
