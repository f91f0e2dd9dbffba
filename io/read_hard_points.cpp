#include "io/read_hard_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/scan_input.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

constexpr std::array<std::string_view, 3> rules{"through", "inside", "outside"};
constexpr std::size_t most_points = 10'000;

double number(const ScanInput& input, std::string_view word) {
  double value = 0.0;
  if (!number_from_word(word, value) || !std::isfinite(value))
    input.fail_line(fmt::format("{} is not a finite number.", shown_word(word)));
  return value;
}

HardPointLine parse(const ScanInput& input, std::string_view line) {
  HardPointLine result;
  for (int axis = 0; axis < 3; ++axis) result.point[axis] = number(input, next_word(line));
  result.rule = next_word(line);
  if (std::find(rules.begin(), rules.end(), result.rule) == rules.end()) {
    input.fail_line(
        fmt::format("{} is no rule of a hard point; there are through, inside and outside.",
                    shown_word(result.rule)));
  }
  const std::string_view margin = next_word(line);
  if (!margin.empty()) result.margin = number(input, margin);
  if (result.margin < 0.0) input.fail_line("the margin of a hard point must not be negative.");
  if (!next_word(line).empty())
    input.fail_line("a hard point is x y z, a rule and at most a margin; there is more.");
  return result;
}

}  // namespace

std::vector<HardPointLine> read_hard_points(const std::filesystem::path& path) {
  ScanInput input(path);
  std::vector<HardPointLine> points;
  std::string_view line;
  while (input.filled_line(line)) {
    std::string_view rest = line;
    if (next_word(rest).starts_with('#')) continue;
    points.push_back(parse(input, line));
    if (points.size() > most_points)
      input.fail(fmt::format("has over {} hard points.", most_points));
  }
  if (points.empty()) input.fail("has no hard points.");
  return points;
}

}  // namespace bodyline::io
