#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "io/body_section.hpp"

namespace bodyline::cli {

/// The page that shows how well a body fits a scan, as asked for on the command line.
struct ReportRequest {
  Output output;  ///< no page when its path is empty
  std::vector<std::string> sections;
  std::optional<double> range;  ///< mm, of the colours; also that of pictures

  bool wanted() const { return !output.path.empty(); }
};

/// Adds --report, --section and --range.
void add_report_options(CLI::App& command, ReportRequest& request);

/// Looks before any work is done whether the page can be written, its planes can be understood, and
/// there is a page, or for the range a picture, that they are for. `overwrite` and `input` as for
/// check_output. Throws std::invalid_argument.
void check_report(ReportRequest& request, bool overwrite, const std::string& input,
                  bool has_picture = false);

/// The planes asked for.
std::vector<io::SectionPlane> section_planes(const ReportRequest& request);

}  // namespace bodyline::cli
