#pragma once

#include <string>

#include "cli/command.hpp"
#include "cli/fit_text.hpp"
#include "cli/report_options.hpp"
#include "cli/scan_target.hpp"
#include "io/fit_report.hpp"
#include "model/model.hpp"
#include "optimize/deviation.hpp"

namespace bodyline::cli {

/// What the report of a comparison with a scan shows. `model` and `stage` are those of the
/// deviation.
io::FitReport deviation_report(const model::Model& model, model::Stage stage,
                               const PlacedScan& placed, const optimize::Deviation& deviation,
                               const ReportRequest& request);

/// What the report of a fit shows: also where it started, how it went, and outlines.
io::FitReport fit_report(const FittedCar& car, const model::Model& start,
                         const ReportRequest& request);

/// The page, with progress.
std::string report_page(Context& context, io::FitReport& report, const ReportRequest& request);

/// Writes it, all or nothing also where the user stops the program.
void write_report_page(const std::string& page, const ReportRequest& request);

}  // namespace bodyline::cli
