#include "model/team.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

namespace bodyline::model {
namespace {

constexpr int jobs = 2000;
constexpr std::chrono::milliseconds longer_than_a_team_watches{2};

// Plain numbers: the thread sanitizer sees a team that does not order its members' accesses.
struct Counts {
  explicit Counts(int size) : of(size, 0) {}
  std::vector<long> of;
  long sum() const { return std::accumulate(of.begin(), of.end(), 0L); }
};

class Teams : public testing::TestWithParam<int> {};

TEST_P(Teams, EveryMemberWorksOnceInEveryRun) {
  Team team(GetParam());
  ASSERT_EQ(team.size(), GetParam());
  Counts counts(team.size());
  for (int job = 0; job < jobs; ++job) team.run([&](int member) { ++counts.of[member]; });
  EXPECT_EQ(counts.of, std::vector<long>(team.size(), jobs));
}

TEST_P(Teams, ARunSeesWhatTheRunsBeforeAndTheirCallerWrote) {
  Team team(GetParam());
  Counts now(team.size()), before(team.size());
  for (int job = 0; job < jobs; ++job) {
    std::swap(now, before);
    team.run([&](int member) { now.of[member] = 1 + before.of[(member + 1) % team.size()]; });
    ASSERT_EQ(now.sum(), long(team.size()) * (job + 1));
  }
}

TEST_P(Teams, MembersThatFellAsleepWakeForTheNextRun) {
  Team team(GetParam());
  Counts counts(team.size());
  for (int job = 0; job < 5; ++job) {
    std::this_thread::sleep_for(longer_than_a_team_watches);
    team.run([&](int member) { ++counts.of[member]; });
  }
  EXPECT_EQ(counts.sum(), 5L * team.size());
}

TEST_P(Teams, ATeamWithoutWorkEnds) {
  for (int k = 0; k < 20; ++k) Team team(GetParam());
}

TEST_P(Teams, TheCallerIsMemberZero) {
  Team team(GetParam());
  std::vector<std::thread::id> ids(team.size());
  team.run([&](int member) { ids[member] = std::this_thread::get_id(); });
  for (int member = 0; member < team.size(); ++member) {
    EXPECT_EQ(ids[member] == std::this_thread::get_id(), member == 0) << member;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Teams, testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace bodyline::model
