#include "io/report.hpp"

#include "io/report_facts.hpp"
#include "io/report_page.hpp"
#include "io/report_parts.hpp"
#include "io/report_sections.hpp"

namespace bodyline::io {
namespace {

constexpr PictureSize picture_size{1200, 675};

}  // namespace

std::string fair_report_page(const FairReport& report, const PictureSize& pictures) {
  const ReportFacts facts = report_facts(report);
  std::string html = report_verdict_section(report, facts);
  html += report_pictures_section(report, pictures);
  html += report_viewer_section(report);
  html += report_terms_section(report);
  html += report_faces_section(facts);
  html += report_continuity_section(facts);
  html += report_history_section(report);
  html += report_variables_section(report);
  html += report_measures_section(facts);
  html += html_repeat_section(report.command);
  return html_page(report.title, html);
}

void write_fair_report(const FairReport& report, const std::filesystem::path& path,
                       Overwrite overwrite) {
  write_file(path, fair_report_page(report, picture_size), overwrite);
}

}  // namespace bodyline::io
