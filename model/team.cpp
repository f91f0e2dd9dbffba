#include "model/team.hpp"

#include <chrono>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace bodyline::model {
namespace {

constexpr int looks_between_clocks = 64;
constexpr std::chrono::microseconds watch_time{50};
// The others of a team may have lost their processor; then spinning on would keep them from it.
constexpr int looks_before_yielding = 4096;

void pause_briefly() {
#if defined(__SSE2__)
  _mm_pause();
#endif
}

}  // namespace

Team::Team(int size) {
  for (int member = 1; member < size; ++member)
    threads_.emplace_back([this, member] { serve(member); });
}

Team::~Team() {
  stop_ = true;
  job_.fetch_add(1);
  job_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Team::start(Call call, const void* context) {
  call_ = call;
  context_ = context;
  busy_.store(int(threads_.size()), std::memory_order_relaxed);
  job_.fetch_add(1, std::memory_order_release);
  job_.notify_all();
}

void Team::finish() {
  for (int looks = 0; busy_.load(std::memory_order_acquire) > 0; ++looks) {
    if (looks < looks_before_yielding) {
      pause_briefly();
    } else {
      std::this_thread::yield();
    }
  }
}

void Team::serve(int member) {
  unsigned seen = 0;
  while (true) {
    const auto until = std::chrono::steady_clock::now() + watch_time;
    while (job_.load(std::memory_order_acquire) == seen) {
      for (int look = 0; look < looks_between_clocks; ++look) {
        pause_briefly();
        if (job_.load(std::memory_order_acquire) != seen) break;
      }
      if (std::chrono::steady_clock::now() > until) job_.wait(seen, std::memory_order_acquire);
    }
    ++seen;
    if (stop_) return;
    call_(context_, member);
    busy_.fetch_sub(1, std::memory_order_release);
  }
}

}  // namespace bodyline::model
