#include "explore/run_ranks.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <map>
#include <stdexcept>
#include <thread>

#include "explore/rank_messages.hpp"
#include "explore/row_crew.hpp"
#include "explore/study_line.hpp"
#include "explore/thread_count.hpp"

namespace bodyline::explore {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int tasks_per_thread = 4;  // at a time: those that wait hide the way to and fro
// Tasks that are on their way or wait for an earlier one, of those that all threads have.
constexpr int window = 4;
constexpr std::chrono::microseconds pause{100};
// A rank that has not left after so long will not.
constexpr std::chrono::seconds longest_farewell{60};

// Rank 0 while it hands out rows and puts together what comes back.
class Distribution {
 public:
  Distribution(Ranks& ranks, StudyLine& line, const StoreLayout& layout, RowCrew& crew)
      : ranks_(ranks), line_(line), layout_(layout), crew_(crew), free_(ranks.size(), 0) {
    add_threads(0, crew.threads());
    wanted_ = line.next();
  }

  // Ends when all is appended, or the user wants no more, or a rank cannot go on: then everything
  // up to the first missing row is appended, and `failure` says why.
  void run() {
    while (!failure_ && !stopped_ && !line_.should_stop()) {
      try {
        const bool left = hand_out();
        if (!left && wanted_ == line_.next()) break;
        const bool heard = listen();
        const auto rows = crew_.collect(heard ? std::chrono::microseconds(0) : pause);
        if (rows) take_in(0, rows);
      } catch (const std::exception&) {
        failure_ = std::current_exception();
      }
      append_blocks(false);
    }
    crew_.drop();
    append_blocks(true);
  }
  std::exception_ptr failure() const { return failure_; }

 private:
  void add_threads(int rank, int threads) {
    free_[std::size_t(rank)] = threads * tasks_per_thread;
    most_waiting_ += threads * tasks_per_thread * window;
  }

  // To the rank with most room, as long as there is one. False when nothing is left to do.
  bool hand_out() {
    while (unfinished_ < most_waiting_) {
      const auto freest = std::max_element(free_.begin(), free_.end());
      if (*freest == 0) return true;
      const RowsPointer rows = line_.take();
      if (!rows) return false;
      --*freest;
      ++unfinished_;
      const int rank = int(freest - free_.begin());
      if (rank == 0) {
        crew_.measure(rows->first, rows->count);
      } else {
        ranks_.send(rank, note_message({RankWord::measure, rows->first, rows->count, ""}));
      }
    }
    return true;
  }

  // Whether there was anything to hear.
  bool listen() {
    bool heard = false;
    while (const auto message = ranks_.receive()) {
      heard = true;
      if (word_of(message->bytes) == RankWord::rows) {
        take_in(message->from, read_rows(layout_, message->bytes));
        continue;
      }
      const RankNote note = read_note(message->bytes);
      if (note.word == RankWord::ready) {
        add_threads(message->from, note.number);
      } else if (note.word == RankWord::stopped) {
        stopped_ = true;
      } else {
        throw std::runtime_error("rank " + std::to_string(message->from) +
                                 " cannot go on: " + note.sentence);
      }
    }
    return heard;
  }

  // Rows come in any order and leave in that of their numbers.
  void take_in(int rank, const RowsPointer& rows) {
    ++free_[std::size_t(rank)];
    waiting_.emplace(rows->first, rows);
    while (!waiting_.empty() && waiting_.begin()->first == wanted_) {
      const RowsPointer next = waiting_.begin()->second;
      waiting_.erase(waiting_.begin());
      wanted_ = next->first + std::uint64_t(next->count);
      --unfinished_;
      if (RowsPointer block = line_.assemble(next)) encoding_.push_back(crew_.encode(block));
    }
  }

  // Those that are ready; waits when they are too many, or when all are wanted.
  void append_blocks(bool all) {
    const std::size_t most = all ? 0 : std::size_t(2 * crew_.threads());
    while (!encoding_.empty()) {
      auto& block = encoding_.front();
      if (encoding_.size() <= most &&
          block.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
      line_.append(block.get());
      encoding_.pop_front();
    }
  }

  Ranks& ranks_;
  StudyLine& line_;
  const StoreLayout& layout_;
  RowCrew& crew_;
  std::vector<int> free_;  // tasks that each rank could take besides those it has
  int unfinished_ = 0, most_waiting_ = 0;
  std::uint64_t wanted_ = 0;  // the variant that is assembled next
  std::map<std::uint64_t, RowsPointer> waiting_;
  std::deque<std::future<BlockPointer>> encoding_;
  bool stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace

RunProgress RankOwner::run(const std::shared_ptr<const VariantPlan>& plan,
                           const VariantSource& source, StoreWriter& store,
                           const RunOptions& options) {
  shared_ = true;
  ranks_.broadcast(study_message(plan->study));
  const int threads = thread_count(options.threads);
  const StoreLayout layout = store.layout();
  StudyLine line(plan, source, store, options);
  RowCrew crew(plan, source, layout, threads);
  Distribution distribution(ranks_, line, layout, crew);
  distribution.run();
  const RunProgress progress = line.finish();
  if (!distribution.failure()) return progress;
  store.finish();
  std::rethrow_exception(distribution.failure());
}

void RankOwner::send_stop() noexcept {
  try {
    if (!shared_) {
      ranks_.broadcast({});
      return;
    }
    for (int rank = 1; rank < ranks_.size(); ++rank)
      ranks_.send(rank, note_message({RankWord::stop, 0, 0, ""}));
    int here = ranks_.size() - 1;
    const Clock::time_point end = Clock::now() + longest_farewell;
    while (here > 0 && Clock::now() < end) {
      const auto message = ranks_.receive();
      if (!message) std::this_thread::sleep_for(pause);
      if (message && word_of(message->bytes) == RankWord::left) --here;
    }
    if (here > 0) ranks_.abandon();
  } catch (...) {  // a rank is lost
    ranks_.abandon();
  }
}

void RankOwner::release() noexcept {
  if (released_) return;
  released_ = true;
  send_stop();
}

RankOwner::~RankOwner() { release(); }

}  // namespace bodyline::explore
