#include "io/svg_chart_lines.hpp"

#include <fmt/format.h>

#include "io/report_html.hpp"
#include "io/svg_chart_axis.hpp"

namespace bodyline::io {
namespace {

// Pixels above and below the plot; across it everything is in per cent.
constexpr int above = 24, below = 38;
constexpr double left_percent = 0.5, width_percent = 99.0;
// The plot's own coordinates, stretched to whatever the page gives.
constexpr double plot_units = 1000.0;

struct Plot {
  ChartAxis x, y;
  int height = 0;

  bool shows(const ChartPoint& point) const { return x.shows(point.x) && y.shows(point.y); }
  double left(double value) const { return left_percent + width_percent * x.position(value); }
  double top(double value) const { return above + height * (1.0 - y.position(value)); }
};

Plot make_plot(const LineChart& chart) {
  std::vector<double> x, y;
  for (const ChartPoint& point : chart.points) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  return {ChartAxis(x, ChartAxis::Scale::linear), ChartAxis(y, ChartAxis::Scale::logarithmic),
          chart.height - above - below};
}

// Tick labels stand on their lines inside the plot, so that no width is lost beside it.
std::string grid(const Plot& plot) {
  std::string svg;
  for (const double tick : plot.y.ticks()) {
    const double y = plot.top(tick);
    svg +=
        fmt::format("<line class=\"grid\" x1=\"0\" x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>", y);
    svg +=
        fmt::format("<text class=\"tick\" x=\"100%\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                    y - 3.0, ChartAxis::label(tick));
  }
  for (const double tick : plot.x.ticks()) {
    const double position = plot.x.position(tick);
    const char* anchor = position < 0.02 ? "start" : position > 0.98 ? "end" : "middle";
    svg += fmt::format("<text class=\"tick\" x=\"{:.2f}%\" y=\"{}\" text-anchor=\"{}\">{}</text>\n",
                       plot.left(tick), above + plot.height + 16, anchor, ChartAxis::label(tick));
  }
  return svg;
}

// One path, begun anew after every point that has no place.
std::string line(const Plot& plot, const std::vector<ChartPoint>& points) {
  std::string path;
  bool drawing = false;
  for (const ChartPoint& point : points) {
    if (plot.shows(point)) {
      path +=
          fmt::format("{}{:.1f} {:.1f}", drawing ? "L" : "M", plot_units * plot.x.position(point.x),
                      plot_units * (1.0 - plot.y.position(point.y)));
    }
    drawing = plot.shows(point);
  }
  if (path.empty()) return "";
  return fmt::format(
      "<svg x=\"{}%\" y=\"{}\" width=\"{}%\" height=\"{}\" viewBox=\"0 0 {} {}\" "
      "preserveAspectRatio=\"none\" overflow=\"visible\"><path class=\"line\" d=\"{}\"/></svg>\n",
      left_percent, above, width_percent, plot.height, plot_units, plot_units, path);
}

std::string marks(const Plot& plot, const LineChart& chart) {
  std::string svg;
  for (const ChartPoint& point : chart.points) {
    if (!plot.shows(point)) continue;
    svg += fmt::format(
        "<circle class=\"point\" cx=\"{:.2f}%\" cy=\"{:.1f}\" r=\"5\"><title>{} {}: {} "
        "{}</title></circle>\n",
        plot.left(point.x), plot.top(point.y), html_escaped(chart.x_label),
        plain_number(point.x, 6), html_escaped(chart.y_label), plain_number(point.y, 6));
  }
  return svg;
}

}  // namespace

std::string svg_line_chart(const LineChart& chart) {
  if (chart.points.empty()) return "";
  const Plot plot = make_plot(chart);
  std::string svg = fmt::format(
      "<svg class=\"chart\" role=\"img\" aria-label=\"{} against {}\" width=\"100%\" "
      "height=\"{}\">\n",
      html_escaped(chart.y_label), html_escaped(chart.x_label), chart.height);
  svg +=
      fmt::format("<text class=\"axis\" x=\"0\" y=\"12\">{}</text>", html_escaped(chart.y_label));
  svg += fmt::format("<text class=\"axis\" x=\"50%\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                     chart.height - 4, html_escaped(chart.x_label));
  svg += grid(plot) + line(plot, chart.points) + marks(plot, chart);
  return svg + "</svg>\n";
}

}  // namespace bodyline::io
