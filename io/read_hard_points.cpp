#include "io/read_hard_points.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "io/decimal_commas.hpp"
#include "io/scan_input.hpp"
#include "io/scan_words.hpp"
#include "model/largest_coordinate.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t most_points = 10'000;

double number(const ScanInput& input, std::string_view word) {
  double value = 0.0;
  if (!number_from_word(word, value) || !std::isfinite(value))
    input.fail_line(fmt::format("{} is not a finite number.", shown_word(word)));
  if (std::abs(value) > model::largest_coordinate) {
    input.fail_line(fmt::format("{} is beyond {:g} mm; hard points lie in the model's coordinates.",
                                shown_word(word), model::largest_coordinate));
  }
  return value;
}

// One line of words may stand above the points.
bool is_heading(std::string_view line) {
  for (int axis = 0; axis < 3; ++axis) {
    double ignored = 0.0;
    const std::string_view word = next_word(line);
    if (word.empty() || number_from_word(word, ignored)) return false;
  }
  return true;
}

model::HardPoint parse(const ScanInput& input, std::string_view line) {
  model::HardPoint result;
  for (int axis = 0; axis < 3; ++axis) result.point[axis] = number(input, next_word(line));
  const std::string_view name = next_word(line);
  const std::optional<model::HardPointRule> rule = model::rule_from_name(name);
  if (!rule) {
    input.fail_line(fmt::format(
        "{} is no rule of a hard point; there are through, inside and outside.", shown_word(name)));
  }
  result.rule = *rule;
  const std::string_view margin = next_word(line);
  if (!margin.empty()) result.margin = number(input, margin);
  if (result.margin < 0.0) input.fail_line("the margin of a hard point must not be negative.");
  if (!next_word(line).empty())
    input.fail_line("a hard point is x y z, a rule and at most a margin; there is more.");
  return result;
}

}  // namespace

std::vector<model::HardPoint> read_hard_points(const std::filesystem::path& path) {
  ScanInput input(path);
  std::vector<model::HardPoint> points;
  std::string_view line;
  DecimalCommas commas({3, false});
  for (bool first = true; input.filled_line(line);) {
    std::string_view rest = line;
    if (next_word(rest).starts_with('#')) continue;
    if (std::exchange(first, false) && is_heading(line)) continue;
    const std::optional<std::string_view> clear = commas.with_points(line);
    if (!clear) input.fail_line(unclear_commas(line) + ".");
    points.push_back(parse(input, *clear));
    if (points.size() > most_points)
      input.fail(fmt::format("has over {} hard points.", most_points));
  }
  if (points.empty()) input.fail("has no hard points.");
  return points;
}

}  // namespace bodyline::io
