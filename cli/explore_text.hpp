#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explore/estimate_study.hpp"
#include "explore/run_study.hpp"

/// What `explore` tells of a run.
namespace bodyline::cli {

/// "41000/s, 3 min left, valid 120, folded 3, least bending 12.3 (17)": for a line of progress.
std::string progress_text(const explore::Study& study, const explore::RunProgress& run);

std::string result_text(const explore::Study& study, const explore::RunProgress& run,
                        const std::string& path);
nlohmann::ordered_json result_json(const explore::Study& study, const explore::RunProgress& run,
                                   const std::string& path);

/// `threads` 0 stands for all processors.
std::string estimate_text(const explore::VariantPlan& plan, const explore::StudyEstimate& estimate,
                          int threads);
nlohmann::ordered_json estimate_json(const explore::VariantPlan& plan,
                                     const explore::StudyEstimate& estimate, int threads);

}  // namespace bodyline::cli
