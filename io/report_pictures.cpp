#include <algorithm>
#include <array>
#include <vector>

#include "io/report_figure.hpp"
#include "io/report_sections.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

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

}  // namespace

std::string report_pictures_section(const FairReport& report, const PictureSize& size) {
  const std::array faces{model::build(report.before, model::Stage::body),
                         model::build(report.after, model::Stage::body)};
  const double range = std::max(curvature_range(faces[0], Map::mean_curvature),
                                curvature_range(faces[1], Map::mean_curvature));
  std::string html = "<section id=\"pictures\" class=\"gallery\">\n<h2>Before and after</h2>\n";
  for (const Pair& pair : pairs) {
    RenderOptions options = report_picture_options(pair.view, pair.map, size);
    if (pair.map == Map::mean_curvature) options.curvature_range = range;
    html += report_comparison({pair.label, pair.caption}, faces[0], faces[1], options);
  }
  return html + "</section>\n";
}

}  // namespace bodyline::io
