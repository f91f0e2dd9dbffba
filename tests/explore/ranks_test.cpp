// Runs by several ranks, which here are threads of one process; tests/cli/cluster_test.cpp has real
// ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <fstream>
#include <mutex>
#include <thread>

#include "explore/rank_messages.hpp"
#include "explore/run_ranks.hpp"
#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::Bytes;
using explore::RankMessage;
using ::testing::HasSubstr;

constexpr int count = 1500;

// Where the messages of all ranks lie.
struct Post {
  explicit Post(int size) : boxes(std::size_t(size)) {}
  std::mutex mutex;
  std::condition_variable broadcast;
  std::vector<std::deque<RankMessage>> boxes;
  std::optional<Bytes> announced;
};

class ThreadRanks : public explore::Ranks {
 public:
  ThreadRanks(Post& post, int rank) : post_(post), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return int(post_.boxes.size()); }
  void abandon() override { abandoned = true; }
  Bytes broadcast(Bytes bytes) override {
    std::unique_lock lock(post_.mutex);
    if (rank_ == 0) {
      post_.announced = bytes;
      post_.broadcast.notify_all();
    }
    post_.broadcast.wait(lock, [&] { return post_.announced.has_value(); });
    return *post_.announced;
  }
  void send(int to, Bytes bytes) override {
    const std::lock_guard lock(post_.mutex);
    post_.boxes[std::size_t(to)].push_back({rank_, std::move(bytes)});
  }
  std::optional<RankMessage> receive() override {
    const std::lock_guard lock(post_.mutex);
    auto& box = post_.boxes[std::size_t(rank_)];
    if (box.empty()) return std::nullopt;
    RankMessage message = std::move(box.front());
    box.pop_front();
    return message;
  }

  bool abandoned = false;

 private:
  Post& post_;
  int rank_;
};

explore::RunOptions one_thread() {
  explore::RunOptions options;
  options.threads = 1;
  return options;
}

using Serve = std::function<void(explore::Ranks&)>;

void serve(explore::Ranks& ranks) { explore::serve_ranks(ranks, 1, nullptr); }

explore::RunProgress run(const std::filesystem::path& path, int ranks, bool resume = false,
                         const explore::RunOptions& options = one_thread(),
                         const Serve& serve_last = serve) {
  Post post(ranks);
  std::vector<std::jthread> others;
  for (int rank = 1; rank < ranks; ++rank) {
    others.emplace_back([&, rank] {
      ThreadRanks there(post, rank);
      (rank + 1 == ranks ? serve_last : Serve(serve))(there);
    });
  }
  ThreadRanks here(post, 0);
  explore::RankOwner owner(here);
  const explore::Study study = small_study(count, "[keep]\nblock = 128");
  const auto plan = std::make_shared<explore::VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  explore::StoreWriter store =
      resume ? explore::StoreWriter::resume(path, study)
             : explore::StoreWriter::create(path, study, plan->space, source->size(), false);
  const explore::RunProgress progress = owner.run(plan, *source, store, options);
  store.finish();
  return progress;
}

explore::VariantRows rows_of_one_process(const std::filesystem::path& path) {
  const explore::Study study = small_study(count, "[keep]\nblock = 128");
  const auto plan = std::make_shared<explore::VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  explore::StoreWriter store =
      explore::StoreWriter::create(path, study, plan->space, source->size(), false);
  explore::run_study(plan, *source, store);
  store.finish();
  return all_rows(path);
}

// Takes the study, says it is ready, and fails when it is given work.
void fail_at_work(explore::Ranks& ranks) {
  using explore::RankWord;
  ranks.broadcast({});
  ranks.send(0, explore::note_message({RankWord::ready, 0, 1, ""}));
  for (bool failed = false;;) {
    const auto message = ranks.receive();
    if (!message) continue;
    if (explore::word_of(message->bytes) == RankWord::stop) break;
    if (failed) continue;
    failed = true;
    ranks.send(0, explore::note_message({RankWord::failed, 0, 0, "its roof leaks"}));
  }
  ranks.send(0, explore::note_message({RankWord::left, 0, 0, ""}));
}

TEST(Ranks, OfAnyNumberMeasureTheSameBits) {
  const Folder folder;
  const explore::VariantRows one = rows_of_one_process(folder / "one.h5");
  for (const int ranks : {1, 2, 4}) {
    const auto path = folder / (std::to_string(ranks) + ".h5");
    EXPECT_EQ(run(path, ranks).measured, std::uint64_t(count));
    EXPECT_TRUE(same_rows(one, all_rows(path))) << ranks;
  }
}

TEST(Ranks, StoppedAndResumedAreTheSameAsUninterrupted) {
  const Folder folder;
  const explore::VariantRows one = rows_of_one_process(folder / "one.h5");
  std::atomic<int> polls{0};
  explore::RunOptions options = one_thread();
  options.should_stop = [&] { return ++polls % 40 == 0; };
  explore::RunProgress progress = run(folder / "a.h5", 3, false, options);
  EXPECT_LT(progress.done, std::uint64_t(count));
  while (progress.done < std::uint64_t(count)) progress = run(folder / "a.h5", 3, true, options);
  EXPECT_TRUE(same_rows(one, all_rows(folder / "a.h5")));
}

TEST(Ranks, OneThatCannotGoOnEndsTheRunWithItsSentenceAndWhatIsMeasuredStays) {
  const Folder folder;
  const explore::VariantRows one = rows_of_one_process(folder / "one.h5");
  const auto path = folder / "a.h5";
  try {
    run(path, 3, false, one_thread(), fail_at_work);
    FAIL() << "nothing was said";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("rank 2 cannot go on: its roof leaks"));
  }
  EXPECT_LT(explore::StoreReader(path).rows(), std::uint64_t(count));
  run(path, 3, true);
  EXPECT_TRUE(same_rows(one, all_rows(path)));
}

// Cannot reach the others once so many variants are handed out.
class BreakingRanks : public ThreadRanks {
 public:
  BreakingRanks(Post& post, std::uint64_t reach) : ThreadRanks(post, 0), reach_(reach) {}
  void send(int to, Bytes bytes) override {
    if (explore::word_of(bytes) == explore::RankWord::measure &&
        explore::read_note(bytes).first >= reach_)
      throw std::runtime_error("the line is dead");
    ThreadRanks::send(to, std::move(bytes));
  }

 private:
  std::uint64_t reach_;
};

TEST(Ranks, ALineThatBreaksLeavesWhatIsMeasured) {
  // Of 64 variants a task, two ranks have at most 32 tasks that are not put together.
  constexpr std::uint64_t many = 20000, reach = 6400, sure = reach - 32 * 64;
  const Folder folder;
  Post post(2);
  const std::jthread other([&] {
    ThreadRanks there(post, 1);
    serve(there);
  });
  BreakingRanks here(post, reach);
  explore::RankOwner owner(here);
  const explore::Study study = small_study(many, "[keep]\nblock = 128");
  const auto plan = std::make_shared<explore::VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  explore::StoreWriter store =
      explore::StoreWriter::create(folder / "a.h5", study, plan->space, many, false);
  try {
    owner.run(plan, *source, store, one_thread());
    FAIL() << "nothing was said";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the line is dead"));
  }
  EXPECT_GE(explore::StoreReader(folder / "a.h5").rows(), sure);
}

TEST(Ranks, ThatWereReleasedAreNotTroubledAgain) {
  Post post(2);
  std::jthread other([&] {
    ThreadRanks there(post, 1);
    serve(there);
  });
  ThreadRanks here(post, 0);
  explore::RankOwner owner(here);
  owner.release();
  other.join();  // it left before the owner did
  owner.release();
  EXPECT_FALSE(here.abandoned);
}

TEST(Ranks, NobodyWaitsWhenRankZeroHasNothingToDo) {
  Post post(3);
  std::vector<std::jthread> others;
  for (const int rank : {1, 2}) {
    others.emplace_back([&, rank] {
      ThreadRanks there(post, rank);
      serve(there);
    });
  }
  ThreadRanks here(post, 0);
  { const explore::RankOwner owner(here); }
  others.clear();  // waits for them
  EXPECT_FALSE(here.abandoned);
}

TEST(Ranks, AStudyArrivesAsItWasSent) {
  const explore::Study study = small_study(count);
  const explore::Study there = explore::read_study_message(explore::study_message(study));
  ASSERT_EQ(there.inputs.size(), study.inputs.size());
  for (std::size_t k = 0; k < study.inputs.size(); ++k) {
    EXPECT_EQ(there.inputs[k].name, study.inputs[k].name);
    EXPECT_EQ(there.inputs[k].text, study.inputs[k].text);
  }
}

TEST(Ranks, WithAnotherScanAreRefused) {
  const Folder folder;
  std::filesystem::copy_file(std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars/model1.toml",
                             folder / "model1.toml");
  std::ofstream(folder / "a.xyz") << "1 2 3\n";
  std::ofstream(folder / "study.toml") << study_text(
      "model = \"model1.toml\"", "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 2.0] }",
      "scan = { file = \"a.xyz\" }", "kind = \"random\"\ncount = 4");
  const explore::Study study = explore::read_study(folder / "study.toml");
  const Bytes message = explore::study_message(study);
  EXPECT_EQ(explore::read_study_message(message).files, study.files);
  std::ofstream(folder / "a.xyz") << "1 2 4\n";
  try {
    explore::read_study_message(message);
    FAIL() << "nothing was said";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"a.xyz\" is not the same on another rank"));
  }
}

TEST(Ranks, OtherInstructionSetsAreRefused) {
  const Bytes here = explore::study_message(small_study(count));
  ASSERT_EQ(setenv("BODYLINE_ISA", "baseline", 1), 0);
  const Bytes other = explore::study_message(small_study(count));
  unsetenv("BODYLINE_ISA");
  if (here == other) GTEST_SKIP() << "this processor has only the baseline";
  try {
    explore::read_study_message(other);
    FAIL() << "nothing was said";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("set BODYLINE_ISA"));
  }
}

TEST(Ranks, HalfAMessageIsRefused) {
  Bytes message = explore::study_message(small_study(count));
  message.resize(message.size() / 2);
  EXPECT_THROW(explore::read_study_message(message), std::runtime_error);
}

}  // namespace
}  // namespace bodyline::testing
