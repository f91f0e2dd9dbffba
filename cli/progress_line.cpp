#include "cli/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bodyline::cli {
namespace {

constexpr int bar_width = 24;

std::string bar(double fraction) {
  const int full = static_cast<int>(std::lround(bar_width * fraction));
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", bar_width - full);
}

std::string duration(double seconds) {
  const long whole = std::lround(std::floor(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  return fmt::format("{} min {} s", whole / 60, whole % 60);
}

}  // namespace

std::string progress_line(const ProgressState& state, double seconds, int columns) {
  std::string line = "bodyline: " + state.work;
  if (state.fraction >= 0.0) {
    const double fraction = std::min(state.fraction, 1.0);
    line += fmt::format(" {} {:.0f} %", bar(fraction), std::floor(100.0 * fraction));
  }
  line += ", " + duration(seconds);
  if (!state.detail.empty()) line += ", " + state.detail;
  if (static_cast<int>(line.size()) > columns) line.resize(std::max(columns, 0));
  return line;
}

}  // namespace bodyline::cli
