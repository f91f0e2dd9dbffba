#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

constexpr int samples = 4;

struct Pair {
  const char *label, *caption, *view;
  Map map;
};
constexpr std::array<Pair, 4> pairs{{
    {"Paint", "Paint in a studio. Look at how lights run across the edges.", "iso", Map::shade},
    {"Zebra",
     "Stripes of a striped sky, mirrored. A kink of a stripe is a kink of the surface, a break of "
     "its direction a jump of curvature; fair surfaces have calm stripes.",
     "iso", Map::zebra},
    {"Mean curvature",
     "Red bulges outwards, blue inwards. Both pictures have the same scale; deep "
     "colours in narrow strips are tight rounds.",
     "iso", Map::mean_curvature},
    {"Side", "The side, as a parallel projection: proportions and silhouette.", "side", Map::shade},
}};

std::string image(const std::vector<model::Surface>& faces, const Pair& pair,
                  const PictureSize& size, double curvature_range, const std::string& text) {
  RenderOptions options;
  options.view = view_from_name(pair.view);
  options.map = pair.map;
  options.width = size.width;
  options.height = size.height;
  options.samples = samples;
  if (pair.map == Map::mean_curvature) options.curvature_range = curvature_range;
  return fmt::format(
      "<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\"/>", size.width,
      size.height, text, base64(png_bytes(render(faces, options))));
}

std::string figure(const Pair& pair, const std::array<std::vector<model::Surface>, 2>& faces,
                   const PictureSize& size, double curvature_range) {
  const std::string label = pair.label;
  return fmt::format(
      "<figure class=\"compare\" data-label=\"{0}\">\n<h3>{0}</h3>\n<div class=\"stage\">\n<div "
      "class=\"side "
      "before\">{1}<span>before</span></div>\n<div class=\"side "
      "after\">{2}<span>after</span></div>\n"
      "</div>\n<figcaption>{3}</figcaption>\n</figure>\n",
      label, image(faces[0], pair, size, curvature_range, label + ", before"),
      image(faces[1], pair, size, curvature_range, label + ", after"), pair.caption);
}

}  // namespace

std::string report_pictures_section(const FairReport& report, const PictureSize& size) {
  const std::array faces{model::build(report.before, model::Stage::body),
                         model::build(report.after, model::Stage::body)};
  const double range = std::max(curvature_range(faces[0], Map::mean_curvature),
                                curvature_range(faces[1], Map::mean_curvature));
  std::string html = "<section id=\"pictures\">\n<h2>Before and after</h2>\n";
  for (const Pair& pair : pairs) html += figure(pair, faces, size, range);
  return html + "</section>\n";
}

}  // namespace bodyline::io
