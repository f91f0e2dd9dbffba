#include "cli/report_options.hpp"

#include <stdexcept>

#include "cli/number_check.hpp"

namespace bodyline::cli {

void add_report_options(CLI::App& command, ReportRequest& request) {
  command
      .add_option("--report", request.output.path,
                  "Page that shows how well the body fits, .html; none when left out")
      ->type_name("FILE");
  command
      .add_option(
          "--section", request.sections,
          "Plane of a section on the page, for example x=1200, mm; may be repeated; y=0 and "
          "three across the car when left out")
      ->type_name("PLANE")
      ->allow_extra_args(false);
  command
      .add_option("--range", request.range,
                  "Distance at which colours end, mm; found from the scan when left out")
      ->type_name("MM")
      ->check(positive_number());
}

void check_report(ReportRequest& request, bool overwrite, const std::string& input,
                  bool has_picture) {
  section_planes(request);
  if (!request.wanted() && !request.sections.empty())
    throw std::invalid_argument("--section chooses what the page shows; give --report FILE.html");
  if (!request.wanted() && !has_picture && request.range)
    throw std::invalid_argument(
        "--range is of the colours of the page or the picture; give --report FILE.html, or with "
        "deviation -o FILE.png");
  if (!request.wanted()) return;
  request.output.overwrite = overwrite;
  check_output(request.output, input, {".html"});
}

std::vector<io::SectionPlane> section_planes(const ReportRequest& request) {
  std::vector<io::SectionPlane> planes;
  for (const std::string& text : request.sections) {
    planes.push_back(io::section_plane_from_text(text));
  }
  return planes;
}

}  // namespace bodyline::cli
