#pragma once

#include <string>
#include <vector>

namespace bodyline::io {

struct ChartPoint {
  double x = 0.0, y = 0.0;
};

/// A line chart with a logarithmic upright axis as an inline SVG, which takes the width it is given
/// while its text keeps its size. Points say their values when pointed at. Points that have no
/// place on the axes (not finite, or not positive upright) interrupt the line.
struct LineChart {
  std::string x_label, y_label;
  std::vector<ChartPoint> points;
  int height = 220;  ///< pixels
};
std::string svg_line_chart(const LineChart& chart);

}  // namespace bodyline::io
