
#include <chrono>
#include <exception>
#include <thread>

#include "explore/rank_messages.hpp"
#include "explore/row_crew.hpp"
#include "explore/run_ranks.hpp"
#include "explore/thread_count.hpp"
#include "explore/tuned_source.hpp"

namespace bodyline::explore {
namespace {

constexpr std::chrono::microseconds pause{200};

void say(Ranks& ranks, const RankNote& note) { ranks.send(0, note_message(note)); }

// False when rank 0 wants no more.
bool hear(Ranks& ranks, RowCrew& crew) {
  while (const auto message = ranks.receive()) {
    const RankNote note = read_note(message->bytes);
    if (note.word == RankWord::stop) return false;
    crew.measure(note.first, note.number);
  }
  return true;
}

void wait_for_stop(Ranks& ranks) {
  while (true) {
    const auto message = ranks.receive();
    if (message && word_of(message->bytes) == RankWord::stop) return;
    if (!message) std::this_thread::sleep_for(pause);
  }
}

// Returns when rank 0 says stop.
void measure_for_owner(Ranks& ranks, const Bytes& study, int threads,
                       const std::function<bool()>& should_stop) {
  const auto plan = std::make_shared<const VariantPlan>(read_study_message(study));
  const auto source = plan_source(plan);
  const StoreLayout layout(plan->study, plan->space);
  RowCrew crew(plan, *source, layout, threads);
  say(ranks, {RankWord::ready, 0, threads, ""});
  while (hear(ranks, crew)) {
    if (should_stop && should_stop()) {
      crew.drop();
      say(ranks, {RankWord::stopped, 0, 0, ""});
      wait_for_stop(ranks);
      return;
    }
    while (const auto rows = crew.collect(pause)) ranks.send(0, rows_message(layout, *rows));
  }
}

}  // namespace

void serve_ranks(Ranks& ranks, int threads, const std::function<bool()>& should_stop) {
  const Bytes study = ranks.broadcast({});
  if (study.empty()) return;
  try {
    measure_for_owner(ranks, study, thread_count(threads), should_stop);
  } catch (const std::exception& error) {
    say(ranks, {RankWord::failed, 0, 0, error.what()});
    wait_for_stop(ranks);
  }
  say(ranks, {RankWord::left, 0, 0, ""});
}

}  // namespace bodyline::explore
