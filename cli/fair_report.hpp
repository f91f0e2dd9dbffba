#pragma once

#include <string>

#include "io/report.hpp"
#include "model/model.hpp"
#include "optimize/fairness.hpp"

namespace bodyline::cli {

/// What the report of a tuning run shows. `before` is the model that was tuned, `command` the
/// command line that repeats the run.
io::FairReport fair_report(const model::Model& before, const optimize::FairResult& result,
                           const std::string& command);

}  // namespace bodyline::cli
