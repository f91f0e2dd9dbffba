#include <fmt/format.h>

#include <array>

#include "io/fit_report_sections.hpp"
#include "io/report_figure.hpp"
#include "io/report_html.hpp"
#include "io/report_mesh.hpp"
#include "io/report_viewer.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

struct MapPicture {
  const char *label, *view;
};
constexpr std::array<MapPicture, 5> map_pictures{
    {{"Side", "side"}, {"Front", "front"}, {"Rear", "rear"}, {"Top", "top"}, {"Oblique", "iso"}}};

}  // namespace

std::string fit_viewer_section(const FitReport& report) {
  const auto halves = model::Halves::left_and_central;
  const auto after = model::build(report.body, report.stage, halves);
  const auto before = report.before ? model::build(*report.before, report.stage, halves) : after;
  ViewerText text;
  text.blended = report.before.has_value();
  if (!report.scan) {
    const double range = curvature_range(after, Map::mean_curvature);
    text.map = "Mean curvature";
    text.scale = fmt::format("red bulges outwards, blue inwards; to {} per m", html_number(range));
    return report_viewer(report_mesh(before, after, curvature_value(range)), text);
  }
  text.map = "Distances";
  text.scale = fmt::format("blue: the scan lies inside, red: outside; to {} mm; grey: not seen",
                           html_number(report.field.range));
  text.first_look = 2;
  return report_viewer(report_mesh(before, after, field_value(report.field)), text);
}

std::string fit_map_section(const FitReport& report, const PictureSize& size) {
  const std::vector<model::Surface> faces = model::build(report.body, report.stage);
  std::string html =
      "<section class=\"gallery\">\n<h2>Where it fits</h2>\n<p class=\"lead\">Signed distance of "
      "the scan: red where it lies outside of the body, blue inside, grey where it shows nothing. "
      "Points of the right half count for the left.</p>\n";
  for (const MapPicture& picture : map_pictures) {
    RenderOptions options = report_picture_options(picture.view, Map::field, size);
    options.field = &report.field;
    html += report_figure({picture.label, ""}, faces, options);
  }
  return html + "</section>\n";
}

std::string fit_comparison_section(const FitReport& report, const PictureSize& size) {
  if (!report.before) return "";
  const auto before = model::build(*report.before, model::Stage::body);
  const auto after = model::build(report.body, model::Stage::body);
  std::string html = "<section class=\"gallery\">\n<h2>Start and result</h2>\n";
  html += report_comparison({"Oblique", "The model that the fit started from, and the fitted one."},
                            before, after, report_picture_options("iso", Map::shade, size));
  html += report_comparison({"Side", "As a parallel projection; each body fills its picture."},
                            before, after, report_picture_options("side", Map::shade, size));
  html += report_comparison({"Zebra", "Calm stripes are fair surfaces."}, before, after,
                            report_picture_options("iso", Map::zebra, size));
  return html + "</section>\n";
}

}  // namespace bodyline::io
