#include "io/svg_chart_bars.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/report_html.hpp"
#include "io/svg_chart_axis.hpp"

namespace bodyline::io {
namespace {

// Pixels down the chart; across it everything is in per cent.
constexpr int row_height = 34, text_below_row_top = 12, mark_below_row_top = 23, axis_height = 22;
constexpr double left_percent = 1.5, width_percent = 97.0;

std::string percent(double position) {
  return fmt::format("{:.2f}%", left_percent + width_percent * position);
}

std::string grid(const ChartAxis& axis, int height) {
  std::string svg;
  for (const double tick : axis.ticks()) {
    const double position = axis.position(tick);
    const std::string x = percent(position);
    const char* anchor = position < 0.02 ? "start" : position > 0.98 ? "end" : "middle";
    svg +=
        fmt::format("<line class=\"grid\" x1=\"{0}\" x2=\"{0}\" y1=\"0\" y2=\"{1}\"/>", x, height);
    svg += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", x,
                       height + 15, anchor, ChartAxis::label(tick));
  }
  return svg;
}

std::string mark(const ChartAxis& axis, double value, int y, const char* kind) {
  if (!axis.shows(value)) return "";
  return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"4.5\"/>", kind,
                     percent(axis.position(value)), y);
}

std::string row(const ChartAxis& axis, const ChangeBar& bar, int top) {
  const int y = top + mark_below_row_top;
  std::string svg = fmt::format("<g><title>{}: {} before, {} after</title>", html_escaped(bar.name),
                                plain_number(bar.before), plain_number(bar.after));
  svg += fmt::format("<rect class=\"hit\" x=\"0\" y=\"{}\" width=\"100%\" height=\"{}\"/>", top,
                     row_height);
  if (axis.shows(bar.before) && axis.shows(bar.after)) {
    const double before = axis.position(bar.before), after = axis.position(bar.after);
    svg += fmt::format(
        "<rect class=\"span\" x=\"{}\" y=\"{}\" width=\"{:.2f}%\" height=\"5\" rx=\"2.5\"/>",
        percent(std::min(before, after)), y - 2.5, width_percent * std::abs(before - after));
  }
  svg += mark(axis, bar.before, y, "before") + mark(axis, bar.after, y, "after");
  svg += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\">{}</text>", percent(0.0),
                     top + text_below_row_top, html_escaped(bar.name));
  svg += fmt::format("<text class=\"value\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{} → {}</text>",
                     percent(1.0), top + text_below_row_top, plain_number(bar.before, 3),
                     plain_number(bar.after, 3));
  return svg + "</g>\n";
}

}  // namespace

std::string svg_change_bars(const std::vector<ChangeBar>& bars, const std::string& title) {
  if (bars.empty()) return "";
  std::vector<double> values;
  for (const ChangeBar& bar : bars) values.insert(values.end(), {bar.before, bar.after});
  const ChartAxis axis(values, ChartAxis::Scale::logarithmic);
  const int height = row_height * int(bars.size());
  std::string svg = fmt::format(
      "<svg class=\"chart\" role=\"img\" aria-label=\"{}\" width=\"100%\" height=\"{}\">\n",
      html_escaped(title), height + axis_height);
  svg += grid(axis, height);
  for (std::size_t k = 0; k < bars.size(); ++k) svg += row(axis, bars[k], row_height * int(k));
  return svg + "</svg>\n";
}

}  // namespace bodyline::io
