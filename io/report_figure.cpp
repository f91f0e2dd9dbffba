#include "io/report_figure.hpp"

#include <fmt/format.h>

#include "io/report_html.hpp"

namespace bodyline::io {
namespace {

constexpr int samples = 4;

std::string image(const std::vector<model::Surface>& faces, const RenderOptions& options,
                  const std::string& text) {
  return fmt::format(
      "<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\"/>",
      options.width, options.height, text, base64(png_bytes(render(faces, options))));
}

std::string caption(const ReportFigure& figure) {
  return figure.caption.empty() ? "" : "<figcaption>" + figure.caption + "</figcaption>\n";
}

}  // namespace

std::string report_figure(const ReportFigure& figure, const std::vector<model::Surface>& faces,
                          const RenderOptions& options) {
  return fmt::format(
      "<figure class=\"compare\" data-label=\"{0}\">\n<h3>{0}</h3>\n<div "
      "class=\"side\">{1}</div>\n{2}</figure>\n",
      figure.label, image(faces, options, figure.label), caption(figure));
}

std::string report_comparison(const ReportFigure& figure, const std::vector<model::Surface>& before,
                              const std::vector<model::Surface>& after,
                              const RenderOptions& options) {
  return fmt::format(
      "<figure class=\"compare\" data-label=\"{0}\">\n<h3>{0}</h3>\n<div class=\"stage\">\n<div "
      "class=\"side "
      "before\">{1}<span>before</span></div>\n<div class=\"side "
      "after\">{2}<span>after</span></div>\n"
      "</div>\n{3}</figure>\n",
      figure.label, image(before, options, figure.label + ", before"),
      image(after, options, figure.label + ", after"), caption(figure));
}

RenderOptions report_picture_options(const char* view, Map map, const PictureSize& size) {
  RenderOptions options;
  options.view = view_from_name(view);
  options.map = map;
  options.width = size.width;
  options.height = size.height;
  options.samples = samples;
  return options;
}

}  // namespace bodyline::io
