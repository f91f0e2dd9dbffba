#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/command.hpp"
#include "cli/progress_line.hpp"

namespace bodyline::cli {

struct ProgressOptions {
  std::chrono::milliseconds delay{2000};    ///< nothing is shown before
  std::chrono::milliseconds interval{200};  ///< between two drawings
};

/// A line on context.err that says how far a piece of work is: shown while this object lives, once
/// the work takes longer than the delay, and cleared at the end. Shows nothing when err is no
/// terminal or the user wants quiet. A thread of its own draws, so that `update` costs next to
/// nothing and work that never calls it has its time shown all the same. Nothing else may write to
/// context.err meanwhile.
class Progress {
 public:
  Progress(Context& context, std::string work, const ProgressOptions& options = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// May be called from any thread. A negative fraction means not known.
  void update(double fraction, std::string detail = "");

 private:
  void draw_until_stopped(std::stop_token stop);

  std::ostream& err_;
  ProgressOptions options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable_any wake_;
  ProgressState state_;
  std::jthread drawer_;  // last: it uses all of the above
};

}  // namespace bodyline::cli
