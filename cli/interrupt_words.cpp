#include "cli/interrupt_words.hpp"

#include <unistd.h>

#include <atomic>

namespace bodyline::cli {
namespace {

// A signal handler can reach nothing but a global.
std::atomic<const std::string*> last_words{nullptr};
static_assert(std::atomic<const std::string*>::is_always_lock_free);

// Only what a handler may call. SA_RESETHAND has put the usual handling back, which ends the
// program as soon as the handler returns.
extern "C" void say_and_end(int signal) {
  if (const std::string* const line = last_words) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line->data(), line->size());
  }
  ::raise(signal);
}

}  // namespace

// A progress line that stands on a terminal is cleared.
InterruptWords::InterruptWords(const Context& context, const std::string& sentence)
    : line_((context.terminal ? "\r\033[K" : "") + ("bodyline: " + sentence) + "\n") {
  last_words = &line_;
  struct sigaction action {};
  action.sa_handler = say_and_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, &before_interrupt_);
  sigaction(SIGTERM, &action, &before_terminate_);
}

InterruptWords::~InterruptWords() {
  sigaction(SIGINT, &before_interrupt_, nullptr);
  sigaction(SIGTERM, &before_terminate_, nullptr);
  last_words = nullptr;
}

}  // namespace bodyline::cli
