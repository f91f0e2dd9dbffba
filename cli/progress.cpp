#include "cli/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace bodyline::cli {
namespace {

constexpr const char* clear_line = "\r\x1b[K";
constexpr int usual_columns = 80;

// One less than the terminal has, so that the cursor stays on the line.
int terminal_columns() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return (known ? size.ws_col : usual_columns) - 1;
}

}  // namespace

Progress::Progress(Context& context, std::string work, const ProgressOptions& options)
    : err_(*context.err), options_(options), state_{std::move(work), -1.0, ""} {
  if (!context.terminal || context.quiet) return;
  drawer_ = std::jthread([this](std::stop_token stop) { draw_until_stopped(std::move(stop)); });
}

Progress::~Progress() = default;

void Progress::update(double fraction, std::string detail) {
  const std::lock_guard lock(mutex_);
  state_.fraction = fraction;
  state_.detail = std::move(detail);
}

void Progress::draw_until_stopped(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  const auto stopped_within = [&](std::chrono::milliseconds time) {
    return wake_.wait_for(lock, stop, time, [&] { return stop.stop_requested(); });
  };
  if (stopped_within(options_.delay)) return;
  do {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    err_ << clear_line << progress_line(state_, elapsed.count(), terminal_columns()) << std::flush;
  } while (!stopped_within(options_.interval));
  err_ << clear_line << std::flush;
}

}  // namespace bodyline::cli
