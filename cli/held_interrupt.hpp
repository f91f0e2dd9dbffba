#pragma once

#include <csignal>

namespace bodyline::cli {

/// While one lives, Ctrl-C and SIGTERM wait; when it ends the one that came takes its usual course.
/// For short work that must not be broken off, such as putting a file under its name; at most one
/// at a time.
class HeldInterrupt {
 public:
  HeldInterrupt();
  ~HeldInterrupt();
  HeldInterrupt(const HeldInterrupt&) = delete;
  HeldInterrupt& operator=(const HeldInterrupt&) = delete;

 private:
  struct sigaction before_interrupt_ {
  }, before_terminate_{};
};

}  // namespace bodyline::cli
