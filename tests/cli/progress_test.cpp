#include "cli/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace bodyline {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr const char* clear_line = "\r\x1b[K";

/// A stream that one thread writes and another waits for.
class WatchedBuffer : public std::stringbuf {
 public:
  void wait_for_drawing() {
    std::unique_lock lock(mutex_);
    drawn_.wait(lock, [this] { return draws_ > 0; });
  }

 protected:
  int sync() override {
    const std::lock_guard lock(mutex_);
    ++draws_;
    drawn_.notify_all();
    return 0;
  }

 private:
  std::mutex mutex_;
  std::condition_variable drawn_;
  int draws_ = 0;
};

class Progress : public ::testing::Test {
 protected:
  WatchedBuffer buffer;
  std::ostream stream{&buffer};
  cli::Context context{.out = &stream, .err = &stream, .terminal = true};
};

TEST_F(Progress, IsShownAndClearedAtTheEnd) {
  {
    cli::Progress progress(context, "rendering", {.delay = {}, .interval = std::chrono::hours(1)});
    buffer.wait_for_drawing();
  }
  EXPECT_THAT(buffer.str(), HasSubstr("bodyline: rendering"));
  EXPECT_THAT(buffer.str(), EndsWith(clear_line));
}

TEST_F(Progress, IsNotShownBeforeTheDelay) {
  {
    cli::Progress progress(context, "rendering", {.delay = std::chrono::hours(1), .interval = {}});
    progress.update(0.5);
  }
  EXPECT_EQ(buffer.str(), "");
}

TEST_F(Progress, IsNotShownWithoutATerminalOrWhenQuiet) {
  for (const bool terminal : {false, true}) {
    context.terminal = terminal;
    context.quiet = terminal;
    cli::Progress progress(context, "rendering", {.delay = {}, .interval = {}});
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(buffer.str(), "");
}

TEST(ProgressLine, ShowsTheFractionTheTimeAndTheDetail) {
  const std::string line = cli::progress_line({"tuning", 0.5, "bending 12.3"}, 75.0, 100);
  EXPECT_EQ(line, "bodyline: tuning [############............] 50 %, 1 min 15 s, bending 12.3");
}

TEST(ProgressLine, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(cli::progress_line({"writing a.step", -1.0, ""}, 3.9, 100),
            "bodyline: writing a.step, 3 s");
}

TEST(ProgressLine, FitsTheTerminal) {
  EXPECT_EQ(cli::progress_line({"writing a.step", 0.3, "detail"}, 3.0, 20).size(), 20U);
}

}  // namespace
}  // namespace bodyline
