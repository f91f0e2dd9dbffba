#include "cli/interrupt.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <thread>

#include "cli/held_interrupt.hpp"
#include "cli/interrupt_words.hpp"
#include "tests/cli/program_run.hpp"

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

TEST(InterruptWords, AreSaidBeforeTheProgramEnds) {
  const auto ask = [] {
    const cli::InterruptWords words(cli::Context{}, "nothing was written.");
    std::raise(SIGINT);
  };
  EXPECT_EXIT(ask(), ::testing::KilledBySignal(SIGINT), "^bodyline: nothing was written.\n$");
}

TEST(InterruptWords, EndWithTheirScope) {
  const auto ask_after = [] {
    { const cli::InterruptWords words(cli::Context{}, "nothing was written."); }
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(ask_after(), ::testing::KilledBySignal(SIGTERM), "^$");
}

TEST(HeldInterrupt, LetsWorkEndBeforeTheProgramDoes) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto ask = [signal] {
      const cli::HeldInterrupt whole;
      std::raise(signal);
      std::raise(signal);
      std::fputs("written", stderr);
    };
    EXPECT_EXIT(ask(), ::testing::KilledBySignal(signal), "^written$");
  }
}

// TBB's threads do not know what the one that writes has blocked.
TEST(HeldInterrupt, HoldsInAllThreads) {
  const auto ask = [] {
    const cli::HeldInterrupt whole;
    std::thread([] { std::raise(SIGINT); }).join();
    std::fputs("written", stderr);
  };
  EXPECT_EXIT(ask(), ::testing::KilledBySignal(SIGINT), "^written$");
}

TEST(HeldInterrupt, PassesOnWhatCameAndNothingElse) {
  const cli::Interrupt interrupt;
  { const cli::HeldInterrupt whole; }
  EXPECT_FALSE(interrupt.requested());
  {
    const cli::HeldInterrupt whole;
    std::raise(SIGINT);
    EXPECT_FALSE(interrupt.requested());
  }
  EXPECT_TRUE(interrupt.requested());
}

/// Runs of `fit` that get a SIGINT at a known point.
class InterruptedFit : public testing::CommandLine {};

// Reading and placing so many points takes far longer than to see that the program listens.
TEST_F(InterruptedFit, WhileItReadsSaysThatNothingWasWritten) {
  ASSERT_EQ(bodyline({"scan", car("model1"), "-o", "scan.ply", "--points", "400000"}).exit_code, 0);
  testing::StartedProgram program(file("."),
                                  {BODYLINE_PROGRAM, "fit", "scan.ply", "-o", "car.toml"});
  while (program.runs() && !program.catches(SIGINT)) ::usleep(1000);
  program.signal(SIGINT);
  const testing::ProgramRun run = program.wait();
  EXPECT_EQ(run.exit_code, 128 + SIGINT);
  EXPECT_EQ(run.err,
            "bodyline: stopped while reading and placing what is to be fitted; nothing was "
            "written.\n");
  EXPECT_EQ(files(), std::vector<std::string>{"scan.ply"});
}

TEST_F(InterruptedFit, WhileThePageIsMadeHasPrintedTheTableAndKeptTheModel) {
  ASSERT_EQ(bodyline({"scan", car("model1"), "-o", "scan.ply", "--points", "2000"}).exit_code, 0);
  testing::StartedProgram program(file("."), {BODYLINE_PROGRAM, "fit", "scan.ply", "--pose", "none",
                                              "-o", "car.toml", "--report", "car.html"});
  while (program.out().find("fitted model: car.toml\n") == std::string::npos && program.runs())
    ::usleep(1000);
  program.signal(SIGINT);
  const testing::ProgramRun run = program.wait();
  EXPECT_EQ(run.exit_code, 128 + SIGINT);
  EXPECT_THAT(run.err, ::testing::HasSubstr("stopped while making the page car.html"));
  EXPECT_THAT(run.out, ::testing::HasSubstr("Distances in mm"));
  EXPECT_EQ(files(), (std::vector<std::string>{"car.toml", "scan.ply"}));
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
