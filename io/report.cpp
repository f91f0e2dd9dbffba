#include "io/report.hpp"

#include "io/report_assets.hpp"
#include "io/report_facts.hpp"
#include "io/report_html.hpp"
#include "io/report_page.hpp"
#include "io/report_sections.hpp"

namespace bodyline::io {
namespace {

constexpr PictureSize picture_size{1200, 675};

std::string head(const FairReport& report) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
         "name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         html_escaped(report.title) + "</title>\n<style>\n" + std::string(report_style_sheet()) +
         "</style>\n</head>\n";
}

std::string script(std::string_view text) {
  return "<script>\n" + std::string(text) + "</script>\n";
}

}  // namespace

std::string fair_report_page(const FairReport& report, const PictureSize& pictures) {
  const ReportFacts facts = report_facts(report);
  std::string html = head(report) + "<body>\n<main>\n";
  html += report_verdict_section(report, facts);
  html += report_pictures_section(report, pictures);
  html += report_viewer_section(report);
  html += report_terms_section(report);
  html += report_faces_section(facts);
  html += report_continuity_section(facts);
  html += report_history_section(report);
  html += report_variables_section(report);
  html += report_measures_section(facts);
  html += report_repeat_section(report);
  html += "</main>\n" + script(report_script()) + script(report_viewer_script());
  return html + "</body>\n</html>\n";
}

void write_fair_report(const FairReport& report, const std::filesystem::path& path,
                       Overwrite overwrite) {
  write_file(path, fair_report_page(report, picture_size), overwrite);
}

}  // namespace bodyline::io
