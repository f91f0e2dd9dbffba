#include "io/report_parts.hpp"

#include <fmt/format.h>

#include "io/report_assets.hpp"
#include "io/report_html.hpp"
#include "web/assets.hpp"

namespace bodyline::io {
namespace {

std::string head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
         "name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
         "'unsafe-inline'; style-src 'unsafe-inline'; img-src data:\"/>\n<title>" +
         html_escaped(title) + "</title>\n<style>\n" + std::string(report_style_sheet()) +
         "</style>\n</head>\n";
}

std::string script(std::string_view text) {
  return "<script>\n" + std::string(text) + "</script>\n";
}

}  // namespace

std::string html_page(const std::string& title, const std::string& sections) {
  return head(title) + "<body>\n<main>\n" + sections + "</main>\n" + script(report_script()) +
         script(web::report_viewer_script()) + "</body>\n</html>\n";
}

std::string html_tile(const std::string& label, const std::string& value, const std::string& note,
                      bool warning) {
  return fmt::format("<div class=\"tile{}\"><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n",
                     warning ? " warning" : "", label, value, note);
}

std::string html_names_sentence(const std::string& begin, const std::vector<std::string>& names,
                                const char* kind) {
  if (names.empty()) return "";
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + html_escaped(name);
  return fmt::format("<p class=\"{}\">{}: {}.</p>\n", kind, begin, list);
}

std::string html_repeat_section(const std::string& command) {
  return fmt::format(
      "<section>\n<h2>How to repeat this</h2>\n<pre>{}</pre>\n<p class=\"lead\">Bodyline "
      "{}.</p>\n</section>\n",
      html_escaped(command), program_version());
}

}  // namespace bodyline::io
