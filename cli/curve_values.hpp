#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bodyline::cli {

/// A number for all curves, and numbers for single ones.
struct CurveValues {
  std::optional<double> all;
  std::map<std::string, double> by_name;
};

/// What numbers an option takes, and how its refusal says so.
struct NumberRange {
  double low = 0.0, high = 0.0;
  bool whole = false;
};

/// Reads "NUMBER" and "CURVE=NUMBER", each as often as it is given; of one curve the last counts.
/// `option` names the option in messages. Throws std::invalid_argument for what is no number in the
/// range.
CurveValues curve_values(const std::vector<std::string>& texts, const std::string& option,
                         const NumberRange& range);

}  // namespace bodyline::cli
