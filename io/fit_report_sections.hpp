#pragma once

#include <string>

#include "io/fit_report.hpp"
#include "io/render.hpp"

/// The sections of the report of a fit, each a piece of HTML.
namespace bodyline::io {

/// Title, verdict in words, and the numbers that matter most.
std::string fit_verdict_section(const FitReport& report);

/// The body to turn by hand, in the colours of the distances.
std::string fit_viewer_section(const FitReport& report);

/// Pictures of the distances from four sides.
std::string fit_map_section(const FitReport& report, const PictureSize& size);

/// The start and the fitted body under a slider; empty without a fit.
std::string fit_comparison_section(const FitReport& report, const PictureSize& size);

/// Histogram and table of faces.
std::string fit_distances_section(const FitReport& report);

/// Drawn outlines over those of the body, and lines that curves follow; empty without them.
std::string fit_outlines_section(const FitReport& report);

/// Sections of the body with points of the scan.
std::string fit_cuts_section(const FitReport& report);

/// How the median distance fell from round to round; empty without a fit.
std::string fit_history_section(const FitReport& report);

/// Where the scan lies, and what was said about files.
std::string fit_pose_section(const FitReport& report);

}  // namespace bodyline::io
