#pragma once

#include <nlohmann/json.hpp>

#include "optimize/fairness.hpp"

namespace bodyline::cli {

/// The result of `bodyline fair --json`, as docs/command-line.md lists it.
nlohmann::ordered_json fair_json(const optimize::FairResult& result);

/// Unweighted values by name; barriers at several stages add up under "fold".
nlohmann::ordered_json terms_json(const std::vector<model::Term>& terms,
                                  const std::vector<double>& values);

}  // namespace bodyline::cli
