#include "cli/held_interrupt.hpp"

#include <atomic>

namespace bodyline::cli {
namespace {

// A signal handler can reach nothing but a global.
std::atomic<int> held{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void remember_signal(int signal) { held = signal; }

}  // namespace

// A mask would not do: it is of one thread, and another one would take the signal.
HeldInterrupt::HeldInterrupt() {
  held = 0;
  struct sigaction action {};
  action.sa_handler = remember_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &before_interrupt_);
  sigaction(SIGTERM, &action, &before_terminate_);
}

HeldInterrupt::~HeldInterrupt() {
  sigaction(SIGINT, &before_interrupt_, nullptr);
  sigaction(SIGTERM, &before_terminate_, nullptr);
  if (const int signal = held) ::raise(signal);
}

}  // namespace bodyline::cli
