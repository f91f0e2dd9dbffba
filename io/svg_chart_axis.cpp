#include "io/svg_chart_axis.hpp"

#include <algorithm>
#include <cmath>

#include "io/report_html.hpp"
#include "io/round_up.hpp"

namespace bodyline::io {
namespace {

constexpr int most_ticks = 7, fewest_ticks = 2;
constexpr double margin = 0.03;  // of the range, beyond the values on both sides

std::vector<double> linear_ticks(double low, double high) {
  const double step = rounded_up((high - low) / most_ticks);
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    ticks.push_back(k * step);
  }
  return ticks;
}

// The factors times every n-th power of ten, as far as they lie between low and high.
std::vector<double> decade_ticks(double low, double high, const std::vector<double>& factors,
                                 int every) {
  std::vector<double> ticks;
  const int first = int(std::floor(std::log10(low))), last = int(std::ceil(std::log10(high)));
  for (int exponent = first - first % every - every; exponent <= last; exponent += every) {
    for (const double factor : factors) {
      const double tick = factor * std::pow(10.0, exponent);
      if (tick >= low && tick <= high) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::vector<double> logarithmic_ticks(double low, double high) {
  const double decades = std::log10(high / low);
  if (decades > most_ticks - 1)
    return decade_ticks(low, high, {1.0}, int(decades / (most_ticks - 1)) + 1);
  for (const std::vector<double>& factors : {std::vector{1.0}, {1.0, 3.0}, {1.0, 2.0, 5.0}}) {
    std::vector<double> ticks = decade_ticks(low, high, factors, 1);
    if (int(ticks.size()) > fewest_ticks) return ticks;
  }
  return linear_ticks(low, high);
}

}  // namespace

ChartAxis::ChartAxis(const std::vector<double>& values, Scale scale) : scale_(scale) {
  std::vector<double> shown;
  for (const double value : values) {
    if (shows(value)) shown.push_back(scaled(value));
  }
  if (shown.empty()) shown = {0.0};
  const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
  const double range = *high > *low ? *high - *low : std::max(1.0, std::abs(*low));
  low_ = *low - margin * range;
  high_ = *high + margin * range;
  if (scale == Scale::linear) {
    ticks_ = linear_ticks(low_, high_);
  } else {
    ticks_ = logarithmic_ticks(std::pow(10.0, low_), std::pow(10.0, high_));
  }
}

bool ChartAxis::shows(double value) const {
  return std::isfinite(value) && (scale_ == Scale::linear || value > 0.0);
}

double ChartAxis::position(double value) const {
  return std::clamp((scaled(value) - low_) / (high_ - low_), 0.0, 1.0);
}

double ChartAxis::scaled(double value) const {
  return scale_ == Scale::linear ? value : std::log10(value);
}

std::string ChartAxis::label(double tick) { return plain_number(tick, 6); }

}  // namespace bodyline::io
