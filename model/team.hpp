#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace bodyline::model {

/// Threads that wait for short jobs, shorter than a scheduler takes to wake a thread: after a job
/// they keep watching for the next one for some tens of microseconds before they sleep.
class Team {
 public:
  /// `size` members, the caller of `run` included; size - 1 threads are started.
  explicit Team(int size);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return int(threads_.size()) + 1; }

  /// Calls work(member) for every member 0..size-1, member 0 on this thread, and returns when all
  /// are done. Allocates nothing. `work` must not throw. Not for two callers at once.
  template <class Work>
  void run(const Work& work) {
    start([](const void* context, int member) { (*static_cast<const Work*>(context))(member); },
          &work);
    work(0);
    finish();
  }

 private:
  using Call = void (*)(const void* context, int member);
  void start(Call call, const void* context);
  void finish();
  void serve(int member);

  std::vector<std::thread> threads_;
  Call call_ = nullptr;
  const void* context_ = nullptr;
  alignas(64) std::atomic<unsigned> job_{0};  ///< counts jobs; changes when there is a new one
  alignas(64) std::atomic<int> busy_{0};
  std::atomic<bool> stop_{false};
};

}  // namespace bodyline::model
