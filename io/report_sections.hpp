#pragma once

#include <string>

#include "io/render.hpp"
#include "io/report.hpp"
#include "io/report_facts.hpp"

/// The sections of a tuning report, each a piece of HTML.
namespace bodyline::io {

/// Title, verdict in words, and the numbers that matter most.
std::string report_verdict_section(const FairReport& report, const ReportFacts& facts);

/// Pictures before and after, under a slider.
std::string report_pictures_section(const FairReport& report, const PictureSize& size);

/// The body to turn by hand; empty when the two models have different faces.
std::string report_viewer_section(const FairReport& report);

/// The terms of the objective, and bending by face.
std::string report_terms_section(const FairReport& report);
std::string report_faces_section(const ReportFacts& facts);

/// How faces meet at joints, seams and corners.
std::string report_continuity_section(const ReportFacts& facts);

/// How the search went; empty without history.
std::string report_history_section(const FairReport& report);

/// The variables, grouped by kind, largest moves first.
std::string report_variables_section(const FairReport& report);

/// Length, width, height, wheelbase, area and volume.
std::string report_measures_section(const ReportFacts& facts);

}  // namespace bodyline::io
