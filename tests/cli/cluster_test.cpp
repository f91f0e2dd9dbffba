// `explore` as a cluster runs it: several processes that mpirun starts on this machine.

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>

#include "explore/store_reader.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

constexpr int variants = 10000;
// So that a run that is disturbed would go on for a while: mpirun takes up to two seconds to act.
constexpr int many = 150000, very_many = 2000000;

class Cluster : public testing::CommandLine {
 protected:
  void SetUp() override { write_study("study.toml", variants); }

  void write_study(const std::string& name, int count) const {
    write(name, "format = 1\nname = \"test\"\nmodel = \"" + car("model1") +
                    "\"\n[variables]\n"
                    "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 3.05] }\n"
                    "roof = { vary = [\"curve.roof__side_window[1-4].z\"], "
                    "offset = [-20, 20] }\n"
                    "[metrics]\nbending = {}\nheight = {}\n[checks]\nfolds = false\n"
                    "[keep]\nblock = 64\ncompressed = false\n[sampler]\n"
                    "kind = \"sobol\"\ncount = " +
                    std::to_string(count) + "\n");
  }

  // Runs `explore` on so many ranks; their process numbers go into files with the numbers of ranks.
  // With `disturb` that shell command is run when the store is somewhat full; $! is mpirun.
  testing::ProgramRun explore(int ranks, const std::string& arguments,
                              const std::string& disturb = "") const {
    // More ranks than processors; containers forbid the quickest way to pass data.
    const std::string settings =
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
        "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_vader_single_copy_mechanism=none\n";
    const std::string start = BODYLINE_MPIRUN " -n " + std::to_string(ranks) +
                              " sh -c 'echo $$ > $OMPI_COMM_WORLD_RANK; exec bodyline explore "
                              "--threads 1 --commit 0.01 " +
                              arguments + "'";
    const std::string wait =
        " &\nuntil [ \"$(stat -c %s a.h5 2>/dev/null || echo 0)\" -gt 120000 ]; "
        "do sleep 0.01; done\n" +
        disturb + "\nwait $!";
    // With job control, so that what runs in the background hears SIGINT.
    return testing::run_in(file(""),
                           {"bash", "-m", "-c", settings + start + (disturb.empty() ? "" : wait)});
  }
  explore::VariantRows rows(const std::string& name) const {
    const explore::StoreReader store(file(name));
    return store.read(0, int(store.rows()));
  }
  void expect_same(const std::string& a, const std::string& b, int count) const {
    const explore::VariantRows first = rows(a), second = rows(b);
    EXPECT_EQ(first.count, count);
    EXPECT_EQ(first.values, second.values);
    EXPECT_EQ(first.status, second.status);
    EXPECT_EQ(first.cause, second.cause);
    ASSERT_EQ(first.metrics.size(), second.metrics.size());
    EXPECT_EQ(std::memcmp(first.metrics.data(), second.metrics.data(),
                          first.metrics.size() * sizeof(double)),
              0);  // some are NaN
  }
};

TEST_F(Cluster, AnyNumberOfRanksMakesTheSameRows) {
  ASSERT_EQ(bodyline({"explore", "study.toml", "-o", "one.h5"}).exit_code, 0);
  for (const int ranks : {1, 2, 4}) {
    const std::string name = std::to_string(ranks) + ".h5";
    const auto run = explore(ranks, "study.toml -o " + name);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 3) << run.out;
    expect_same("one.h5", name, variants);
  }
}

TEST_F(Cluster, ALostRankEndsTheRunAndTheRestGoesOn) {
  write_study("study.toml", many);
  ASSERT_EQ(bodyline({"explore", "study.toml", "-o", "one.h5"}).exit_code, 0);
  const auto run = explore(3, "study.toml -o a.h5", "kill -9 $(cat 2)");
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("--resume goes on"));
  const int kept = rows("a.h5").count;
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, many);
  const auto rest = explore(3, "study.toml -o a.h5 --resume");
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  expect_same("one.h5", "a.h5", many);
}

TEST_F(Cluster, CtrlCKeepsWhatIsMeasured) {
  write_study("long.toml", very_many);
  const auto run = explore(2, "long.toml -o a.h5", "kill -INT $!");
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("--resume goes on"));
  EXPECT_GT(rows("a.h5").count, 0);
  EXPECT_LT(rows("a.h5").count, very_many);
}

TEST_F(Cluster, WhatIsWrongIsSaidOnce) {
  write("taken.h5", "no store");
  const auto refused = [&](const std::string& arguments, const char* sentence) {
    const auto run = explore(3, arguments);
    EXPECT_EQ(run.exit_code, 2);
    const std::size_t said = run.err.find(sentence);
    ASSERT_NE(said, std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("bodyline: ", said), std::string::npos) << run.err;
  };
  refused("none.toml -o a.h5", "none.toml: does not exist.");
  refused("study.toml -o taken.h5", "exists already");
  refused("study.toml --colour", "--colour");
}

}  // namespace
}  // namespace bodyline
