#include <fmt/format.h>

#include <optional>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"
#include "model/factors.hpp"

namespace bodyline::io {
namespace {

std::string row(const char* name, const char* unit, int decimals, std::optional<double> before,
                std::optional<double> after, double divisor = 1.0) {
  if (!before || !after) return "";
  const auto cell = [&](double value, const char* sign) {
    const std::string text = fmt::format("{:.{}f}", value / divisor, decimals);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    const bool negative = value < 0.0 && !zero;
    return fmt::format("<td class=\"number\" title=\"{}\">{}{}</td>", exact_number(value / divisor),
                       negative ? "−" : (zero ? "" : sign), text.substr(text[0] == '-' ? 1 : 0));
  };
  return fmt::format("<tr><th scope=\"row\">{} <small>{}</small></th>{}{}{}</tr>\n", name, unit,
                     cell(*before, ""), cell(*after, ""), cell(*after - *before, "+"));
}

}  // namespace

std::string report_measures_section(const ReportFacts& facts) {
  const model::BodyTotals &before = facts.before.totals, &after = facts.after.totals;
  const Eigen::Vector3d size_before = before.box.size(), size_after = after.box.size();
  std::string html =
      "<section>\n<h2>Dimensions</h2>\n<div class=\"scroll\"><table>\n<thead><tr><th "
      "scope=\"col\">Of the whole "
      "body</th><th class=\"number\" scope=\"col\">Before</th><th class=\"number\" "
      "scope=\"col\">After</th>"
      "<th class=\"number\" scope=\"col\">Change</th></tr></thead>\n<tbody>\n";
  html += row("Length", "mm", 1, size_before.x(), size_after.x());
  html += row("Width", "mm", 1, size_before.y(), size_after.y());
  html += row("Height", "mm", 1, size_before.z(), size_after.z());
  html += row("Wheelbase", "mm", 1, before.wheelbase_mm, after.wheelbase_mm);
  html += row("Area", "m²", 3, before.area_mm2, after.area_mm2, model::square_mm_per_square_m);
  html += row("Volume above the ground", "m³", 3, before.volume_mm3, after.volume_mm3,
              model::cubic_mm_per_cubic_m);
  return html + "</tbody></table></div>\n</section>\n";
}

}  // namespace bodyline::io
