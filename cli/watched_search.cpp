#include "cli/watched_search.hpp"

#include <fmt/format.h>

namespace bodyline::cli {

WatchedSearch::WatchedSearch(Context& context, optimize::Options& search)
    : progress_(context, "tuning") {
  search.should_stop = [this] { return interrupt_.requested(); };
  search.on_progress = [this](const optimize::Progress& step) {
    progress_.update(-1.0,
                     fmt::format("evaluation {}, objective {:.6g}", step.evaluation, step.value));
  };
}

}  // namespace bodyline::cli
