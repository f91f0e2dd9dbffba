#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/palette.hpp"
#include "io/render_map.hpp"
#include "io/report_html.hpp"
#include "io/report_sections.hpp"
#include "io/report_viewer.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

constexpr int colors = 64;

// The scale of the pictures, as RGB bytes.
std::vector<std::uint8_t> map_colors() {
  std::vector<std::uint8_t> bytes;
  for (int k = 0; k < colors; ++k) {
    const Color color = diverging_color(2.0 * k / (colors - 1) - 1.0);
    for (int c = 0; c < 3; ++c) {
      bytes.push_back(static_cast<std::uint8_t>(255.0f * srgb_from_linear(color[c]) + 0.5f));
    }
  }
  return bytes;
}

std::string data(const char* id, const std::vector<std::uint8_t>& bytes) {
  return fmt::format("<script type=\"application/octet-stream\" id=\"{}\">{}</script>\n", id,
                     base64(bytes));
}

}  // namespace

std::string report_viewer(const ReportMesh& mesh, const ViewerText& text) {
  if (mesh.cells == 0) return "";
  std::string mirrored;
  for (const bool face : mesh.mirrored) mirrored += face ? '1' : '0';
  const std::string slider =
      text.blended ? "<label>before <input class=\"blend\" type=\"range\" min=\"0\" max=\"1\" "
                     "step=\"0.01\" value=\"1\"/> after</label>"
                   : "";
  std::string html = fmt::format(
      "<section id=\"viewer\" hidden=\"hidden\" data-cells=\"{0}\" data-mirrored=\"{1}\" "
      "data-stripe=\"{2}\" data-look=\"{3}\">\n<h2>Turn it</h2>\n"
      "<p class=\"lead\">Drag to turn, hold Ctrl and scroll to come closer, double-click to "
      "return.{4}</p>\n<div class=\"canvas\"><canvas "
      "tabindex=\"0\" aria-label=\"The body in three dimensions\"></canvas></div>\n<div "
      "class=\"controls\">{5}<div class=\"tabs\" role=\"group\" aria-label=\"Colours\">"
      "<button>Paint</button><button>Zebra</button><button>{6}</button></div><span "
      "class=\"scale\">{7}</span></div>\n",
      mesh.cells, mirrored, plain_number(zebra_stripe), text.first_look,
      text.blended ? " The slider blends the body before into the one after." : "", slider,
      text.map, text.scale);
  html += data("mesh-before", mesh.before) + data("mesh-after", mesh.after);
  return html + data("map-colors", map_colors()) + "</section>\n";
}

std::string report_viewer_section(const FairReport& report) {
  const auto before =
      model::build(report.before, model::Stage::body, model::Halves::left_and_central);
  const auto after =
      model::build(report.after, model::Stage::body, model::Halves::left_and_central);
  const double range = std::max(curvature_range(before, Map::mean_curvature),
                                curvature_range(after, Map::mean_curvature));
  ViewerText text;
  text.map = "Mean curvature";
  text.scale = fmt::format("colours from −{0} to {0} 1/m", plain_number(range));
  return report_viewer(report_mesh(before, after, curvature_value(range)), text);
}

}  // namespace bodyline::io
