#include <fmt/format.h>

#include "io/fit_report_sections.hpp"
#include "io/report_html.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

std::string figure(const SectionPlane& plane, const std::string& svg) {
  return fmt::format("<figure class=\"cut-figure\">\n<h3>{}</h3>\n{}</figure>\n",
                     html_escaped(plane.name()), svg);
}

}  // namespace

std::string fit_cuts_section(const FitReport& report) {
  const std::vector<model::Surface> left =
      model::build(report.body, report.stage, model::Halves::left_and_central);
  const std::vector<SectionPlane> planes =
      report.sections.empty() ? usual_section_planes(left) : report.sections;
  std::string figures;
  for (SectionPlane plane : planes) {
    if (plane.axis == 1 && plane.at > 0.0) plane.at = -plane.at;  // where the points are
    const std::string svg = svg_section(left, plane, report.points, report.field.range);
    figures += svg.empty() ? fmt::format("<p>The plane {} misses the body.</p>\n",
                                         html_escaped(plane.name()))
                           : figure(plane, svg);
  }
  const std::string dots =
      report.scan ? ", points of the scan as dots: grey near it, blue inside, red outside. Points "
                    "of the right half are mirrored to the left, and sections across the car show "
                    "that half, seen from behind. "
                  : ". Sections across the car show the left half, seen from behind. ";
  return "<section id=\"cuts\">\n<h2>Sections</h2>\n<p class=\"lead\">The body as a line" + dots +
         "<span class=\"live-only\">Hold Ctrl and scroll to come closer, drag to move, "
         "double-click to return.</span></p>\n<div class=\"cuts\">\n" +
         figures + "</div>\n</section>\n";
}

}  // namespace bodyline::io
