#pragma once

#include <csignal>
#include <string>

#include "cli/command.hpp"

namespace bodyline::cli {

/// While one lives, Ctrl-C or SIGTERM ends the program as it would without it, but with a sentence
/// on standard error first. For work that does not poll and leaves nothing half written; at most
/// one at a time, and none beside an Interrupt.
class InterruptWords {
 public:
  /// `sentence` says what was going on and what is written.
  InterruptWords(const Context& context, const std::string& sentence);
  ~InterruptWords();
  InterruptWords(const InterruptWords&) = delete;
  InterruptWords& operator=(const InterruptWords&) = delete;

 private:
  std::string line_;
  struct sigaction before_interrupt_ {
  }, before_terminate_{};
};

}  // namespace bodyline::cli
