#pragma once

#include <csignal>

namespace bodyline::cli {

/// While one lives, Ctrl-C asks for a stop instead of ending the program; a second Ctrl-C ends it.
/// Only for work that polls `requested`; at most one at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;

 private:
  struct sigaction before_ {};
};

}  // namespace bodyline::cli
