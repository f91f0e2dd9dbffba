#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/write_file.hpp"

namespace bodyline::io {

/// Points of one kind.
struct ScatterSeries {
  std::string name;  ///< for the legend; none when empty
  std::vector<double> x, y;
  int color = 0;        ///< 0: grey, 1 and above: colours that are easy to tell apart
  double radius = 1.5;  ///< pixels
  bool joined = false;  ///< by a line, in their order
};

/// A scatter plot with linear or logarithmic axes. Points that are not finite, and on a logarithmic
/// axis those that are not positive, are left out.
struct ScatterPlot {
  std::string x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<ScatterSeries> series;  ///< drawn in this order
  int width = 900, height = 640;      ///< pixels
};

/// Draws it to a file, as its extension says: .png or .svg. Throws std::invalid_argument for any
/// other, and as write_file does.
void write_scatter_plot(const ScatterPlot& plot, const std::filesystem::path& path,
                        Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
