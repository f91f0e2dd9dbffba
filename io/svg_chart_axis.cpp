#include "io/svg_chart_axis.hpp"

#include <algorithm>
#include <cmath>

#include "io/report_html.hpp"

namespace bodyline::io {
namespace {

constexpr int most_ticks = 7;

// 1, 2 or 5 times a power of ten, not below `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (step <= factor * power * (1.0 + 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> linear_ticks(double low, double high) {
  if (!(high > low)) {
    const double margin = low == 0.0 ? 1.0 : 0.5 * std::abs(low);
    low -= margin;
    high += margin;
  }
  const double step = round_step((high - low) / (most_ticks - 2));
  std::vector<double> ticks;
  const double first = std::floor(low / step * (1.0 + 1e-12));
  for (double k = first; ticks.size() < 2 || ticks.back() < high - 1e-9 * step; ++k) {
    ticks.push_back(k * step);
  }
  return ticks;
}

// Powers of ten; within two decades also 2 and 5 times these. Only what the values need.
std::vector<double> logarithmic_ticks(double low, double high) {
  const int first = int(std::floor(std::log10(low))), last = int(std::ceil(std::log10(high)));
  const int every = std::max(1, (last - first + most_ticks - 1) / most_ticks);
  std::vector<double> ticks;
  for (int exponent = first; exponent <= last + every - 1; exponent += every) {
    const double power = std::pow(10.0, exponent);
    ticks.push_back(power);
    if (last - first > 2 || exponent == last) continue;
    ticks.insert(ticks.end(), {2.0 * power, 5.0 * power});
  }
  if (ticks.size() < 2) ticks.push_back(10.0 * ticks.back());
  while (ticks.size() > 2 && ticks[1] <= low) ticks.erase(ticks.begin());
  while (ticks.size() > 2 && ticks[ticks.size() - 2] >= high) ticks.pop_back();
  return ticks;
}

}  // namespace

ChartAxis::ChartAxis(const std::vector<double>& values, Scale scale) : scale_(scale) {
  std::vector<double> shown;
  for (const double value : values) {
    if (shows(value)) shown.push_back(value);
  }
  if (shown.empty()) shown = {1.0};
  const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
  ticks_ = scale == Scale::linear ? linear_ticks(*low, *high) : logarithmic_ticks(*low, *high);
  low_ = scaled(ticks_.front());
  high_ = scaled(ticks_.back());
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

std::string ChartAxis::label(double tick) { return plain_number(tick, 3); }

}  // namespace bodyline::io
