#pragma once

#include <csignal>

namespace bodyline::cli {

/// While one lives, Ctrl-C, or SIGTERM as mpirun and batch systems send it, asks for a stop instead
/// of ending the program; a second one of the same kind ends it.
/// Only for work that polls `requested`; at most one at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;

 private:
  struct sigaction before_interrupt_ {
  }, before_terminate_{};
};

}  // namespace bodyline::cli
