#include <fmt/format.h>

#include "io/report_assets.hpp"
#include "io/report_html.hpp"
#include "io/report_sections.hpp"

namespace bodyline::io {

std::string report_repeat_section(const FairReport& report) {
  return fmt::format(
      "<section>\n<h2>How to repeat this</h2>\n<pre>{}</pre>\n<p class=\"lead\">Bodyline "
      "{}.</p>\n</section>\n",
      html_escaped(report.command), program_version());
}

}  // namespace bodyline::io
