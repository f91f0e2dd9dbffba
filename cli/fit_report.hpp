#pragma once

#include <string>

#include "cli/command.hpp"
#include "cli/report_options.hpp"
#include "cli/scan_target.hpp"
#include "io/fit_report.hpp"
#include "model/model.hpp"
#include "optimize/deviation.hpp"
#include "optimize/fit_scan.hpp"

namespace bodyline::cli {

/// What the report of a comparison shows. `model` and `stage` are those of the deviation.
io::FitReport deviation_report(const model::Model& model, model::Stage stage,
                               const PlacedScan& placed, const optimize::Deviation& deviation,
                               const ReportRequest& request);

/// Adds what a fit knows more: where it started and how it went.
void add_fit(io::FitReport& report, const model::Model& start, const optimize::FitResult& result);

/// Writes the page, with progress.
void write_report(Context& context, io::FitReport& report, const ReportRequest& request);

}  // namespace bodyline::cli
