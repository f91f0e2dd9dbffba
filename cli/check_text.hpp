#pragma once

#include <string>
#include <vector>

#include "model/check_findings.hpp"

namespace bodyline::cli {

/// A check as text for people: findings and warnings first, then the tables of edges and faces, the
/// sizes, and one sentence that sums up. `warnings` are those of the model file.
std::string check_text(const model::BodyCheck& check, const std::vector<std::string>& findings,
                       const std::vector<std::string>& warnings);

}  // namespace bodyline::cli
