#include "io/svg_histogram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/palette.hpp"
#include "io/report_html.hpp"
#include "io/surface_field.hpp"
#include "io/svg_color.hpp"

namespace bodyline::io {
namespace {

constexpr int bins = 41;  // odd: one stands for zero
constexpr int plot_height = 170, height = 230;
constexpr float darker = 0.82f;  // for the palest colours to stand out from the page

std::string bar(int k, std::size_t count, std::size_t most, std::size_t all, double range) {
  const double width = 100.0 / bins, tall = plot_height * double(count) / double(most);
  const double low = range * (2.0 * k / bins - 1.0), high = range * (2.0 * (k + 1) / bins - 1.0);
  const std::string where =
      k == 0          ? fmt::format("below {} mm", plain_number(high, 3))
      : k == bins - 1 ? fmt::format("beyond {} mm", plain_number(low, 3))
                      : fmt::format("{} to {} mm", plain_number(low, 3), plain_number(high, 3));
  return fmt::format(
      "<rect x=\"{:.2f}%\" y=\"{:.1f}\" width=\"{:.2f}%\" height=\"{:.1f}\" "
      "fill=\"{}\"><title>{}: {} points, {:.1f} %</title></rect>\n",
      k * width, plot_height - tall, 0.86 * width, tall,
      svg_color(darker * diverging_color(2.0 * (k + 0.5) / bins - 1.0)), where, count,
      100.0 * double(count) / double(all));
}

}  // namespace

std::string svg_histogram(const std::vector<double>& values, double range,
                          const std::string& label) {
  if (values.empty()) return "";
  const std::vector<std::size_t> counts = histogram(values, range, bins);
  const std::size_t most =
      std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  std::string svg = fmt::format(
      "<svg class=\"chart\" role=\"img\" aria-label=\"{0}\" width=\"100%\" height=\"{1}\">\n",
      html_escaped(label), height);
  for (int k = 0; k < bins; ++k) {
    svg += bar(k, counts[std::size_t(k)], most, values.size(), range);
  }
  svg += fmt::format("<line class=\"grid\" x1=\"0\" x2=\"100%\" y1=\"{0}\" y2=\"{0}\"/>\n",
                     plot_height + 0.5);
  for (int k = -2; k <= 2; ++k) {
    svg += fmt::format("<text class=\"tick\" x=\"{}%\" y=\"{}\" text-anchor=\"{}\">{}</text>\n",
                       50 + 25 * k, plot_height + 18,
                       k == -2  ? "start"
                       : k == 2 ? "end"
                                : "middle",
                       html_number(0.5 * k * range));
  }
  svg += fmt::format("<text class=\"axis\" x=\"50%\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                     height - 8, html_escaped(label));
  return svg + "</svg>\n";
}

}  // namespace bodyline::io
