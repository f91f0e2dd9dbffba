#pragma once

#include <string>
#include <vector>

namespace bodyline::io {

/// One axis of a chart: from values to positions between 0 and 1, with round ticks.
class ChartAxis {
 public:
  enum class Scale { linear, logarithmic };

  /// Covers all finite values and a little more; values that are not finite are passed over, and on
  /// a logarithmic axis those that are not positive too.
  ChartAxis(const std::vector<double>& values, Scale scale);

  /// Whether a value has a place on the axis.
  bool shows(double value) const;
  /// Position of a value that it shows, 0 at the low end.
  double position(double value) const;
  const std::vector<double>& ticks() const { return ticks_; }
  static std::string label(double tick);

 private:
  double scaled(double value) const;

  Scale scale_;
  double low_ = 0.0, high_ = 1.0;  // scaled
  std::vector<double> ticks_;
};

}  // namespace bodyline::io
