#include "io/surface_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "io/round_up.hpp"

namespace bodyline::io {

double FaceField::sample(double u, double v) const {
  const auto cell = [&](double t) { return std::clamp(int(t * cells), 0, cells - 1); };
  if (cells == 0 || std::isnan(at(cell(u), cell(v)))) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double x = u * cells - 0.5, y = v * cells - 0.5;
  const int i = int(std::floor(x)), j = int(std::floor(y));
  double sum = 0.0, weights = 0.0;
  for (int k = 0; k < 4; ++k) {
    const int di = k / 2, dj = k % 2;
    const double value = at(std::clamp(i + di, 0, cells - 1), std::clamp(j + dj, 0, cells - 1));
    if (std::isnan(value)) continue;
    const double weight = (1.0 - std::abs(x - i - di)) * (1.0 - std::abs(y - j - dj));
    sum += weight * value;
    weights += weight;
  }
  return sum / weights;
}

const FaceField* SurfaceField::face(const std::string& name) const {
  constexpr std::string_view suffix = ".right";
  const std::string_view plain =
      std::string_view(name).substr(0, name.size() - (name.ends_with(suffix) ? suffix.size() : 0));
  const auto found = std::find_if(faces.begin(), faces.end(),
                                  [&](const FaceField& field) { return field.name == plain; });
  return found == faces.end() ? nullptr : &*found;
}

Color unknown_color() { return color_from_srgb(150, 154, 160); }

double symmetric_range(std::vector<double> values, double share) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return 1.0;
  for (double& value : values) value = std::abs(value);
  const auto at = std::min(std::size_t(share * double(values.size())), values.size() - 1);
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at] > 0.0 ? rounded_up(values[at]) : 1.0;
}

std::vector<std::size_t> histogram(const std::vector<double>& values, double range, int bins) {
  std::vector<std::size_t> counts(std::size_t(bins), 0);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double at = std::clamp((value / range + 1.0) / 2.0, 0.0, 1.0) * bins;
    ++counts[std::size_t(std::min(int(at), bins - 1))];
  }
  return counts;
}

}  // namespace bodyline::io
