#pragma once

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "optimize/minimize.hpp"

namespace bodyline::cli {

/// While one lives, the search of these options tells how far it is, and stops at Ctrl-C.
class WatchedSearch {
 public:
  /// `search` must not run when this has ended.
  WatchedSearch(Context& context, optimize::Options& search);

 private:
  Interrupt interrupt_;
  Progress progress_;
};

}  // namespace bodyline::cli
