#include "io/fit_report.hpp"

#include "io/fit_report_sections.hpp"
#include "io/report_parts.hpp"

namespace bodyline::io {

std::string fit_report_page(const FitReport& report, const PictureSize& pictures) {
  std::string html = fit_verdict_section(report);
  html += fit_viewer_section(report);
  if (report.scan) html += fit_map_section(report, pictures);
  if (report.scan) html += fit_distances_section(report);
  html += fit_outlines_section(report);
  html += fit_cuts_section(report);
  html += fit_comparison_section(report, pictures);
  html += fit_history_section(report);
  html += fit_pose_section(report);
  html += html_repeat_section(report.command);
  return html_page(report.title, html);
}

void write_fit_report(const FitReport& report, const std::filesystem::path& path,
                      Overwrite overwrite) {
  write_file(path, fit_report_page(report, fit_report_pictures), overwrite);
}

}  // namespace bodyline::io
