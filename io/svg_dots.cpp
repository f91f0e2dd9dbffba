#include "io/svg_dots.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/palette.hpp"
#include "io/svg_color.hpp"

namespace bodyline::io {
namespace {

// Steps of the colours, from far below to far above.
constexpr std::array<double, 5> steps{-1.0, -0.55, 0.0, 0.55, 1.0};

std::string step_color(double step) {
  return svg_color(step == 0.0 ? color_from_srgb(120, 128, 138) : diverging_color(step));
}

int step_of(double distance, double range) {
  const double t = distance / range;
  return std::abs(t) <= 0.25 ? 2 : t < 0.0 ? (t < -0.5 ? 0 : 1) : (t > 0.5 ? 4 : 3);
}

}  // namespace

std::string svg_dots(const std::vector<SvgDot>& dots, double range) {
  std::array<std::string, steps.size()> paths;
  for (const SvgDot& dot : dots) {
    paths[std::size_t(step_of(dot.distance, range))] +=
        fmt::format("M{:.1f} {:.1f}h0", dot.at.x(), dot.at.y());  // a line without length
  }
  std::string svg;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (paths[k].empty()) continue;
    svg += fmt::format("<path class=\"dots\" stroke=\"{}\" d=\"{}\"/>\n", step_color(steps[k]),
                       paths[k]);
  }
  return svg;
}

}  // namespace bodyline::io
