#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/bounds_options.hpp"
#include "cli/drawn_text.hpp"
#include "cli/scan_target.hpp"
#include "optimize/arch_gaps.hpp"
#include "optimize/deviation.hpp"
#include "optimize/fit_body.hpp"

namespace bodyline::cli {

/// A fit: what a body was fitted to, and how well it meets that.
struct FittedCar {
  std::optional<PlacedScan> scan;
  DrawnTarget drawn;
  optimize::Bounds bounds;
  optimize::FitResult result;
  std::optional<optimize::Deviation> deviation;  ///< from the scan
  std::vector<optimize::ArchGap> arches;         ///< likewise
  DrawnKept kept;
  optimize::BoundsKept bounds_kept;
  double seconds = 0.0;  ///< from the files to the model
};

/// Whether something is not as it should be: the fit failed, a bound is not kept, a face folds.
bool has_findings(const FittedCar& car);

/// Sentences on parts of wheel arches that are over 10 mm off the scan's.
std::vector<std::string> arch_warnings(const std::vector<optimize::ArchGap>& arches);
/// The parts of the model's wheel arches that are not among those that were measured, in words;
/// empty when there are none.
std::string hidden_arches(const model::Model& model, const std::vector<optimize::ArchGap>& arches);

/// The document that `fit --json` prints (docs/fitting.md).
nlohmann::ordered_json fit_json(const FittedCar& car);

/// The same to be read.
std::string fit_text(const FittedCar& car);

}  // namespace bodyline::cli
