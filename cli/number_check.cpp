#include "cli/number_check.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <optional>

namespace bodyline::cli {
namespace {

std::optional<double> finite_number(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

CLI::Validator checked(const std::function<bool(double)>& allowed, const std::string& words) {
  return CLI::Validator(
      [=](const std::string& text) {
        const std::optional<double> value = finite_number(text);
        return value && allowed(*value) ? std::string() : fmt::format("{} is not {}", text, words);
      },
      "");
}

}  // namespace

CLI::Validator positive_number() {
  return checked([](double x) { return x > 0.0; }, "a number above 0");
}

CLI::Validator non_negative_number() {
  return checked([](double x) { return x >= 0.0; }, "a number of 0 or more");
}

CLI::Validator number_between(double low, double high) {
  return checked([=](double x) { return x >= low && x <= high; },
                 fmt::format("a number from {} to {}", low, high));
}

}  // namespace bodyline::cli
