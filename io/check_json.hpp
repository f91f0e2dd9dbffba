#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/check_body.hpp"
#include "model/check_findings.hpp"

namespace bodyline::io {

/// A check as JSON (docs/checks.md): "model", "stage", "edges", "patches", "totals", "findings" and
/// "warnings". What cannot be computed, or does not exist, is null. `warnings` are those of the
/// model file; those of the check follow.
nlohmann::ordered_json check_json(const model::BodyCheck& check,
                                  const std::vector<std::string>& findings,
                                  std::vector<std::string> warnings = {});

}  // namespace bodyline::io
