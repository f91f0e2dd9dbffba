#include "optimize/align_unit.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace bodyline::optimize {
namespace {

// From microcars to limousines, with some room for mirrors, bars and a slanted box.
constexpr double shortest_mm = 2200.0;
constexpr double longest_mm = 8000.0;
// The middle of the usual lengths on a logarithmic scale: 10 and 25.4 mm differ by a factor of 2.5,
// usual cars (2700 to 6200 mm) by less.
constexpr double usual_mm = 4100.0;

const std::array<LengthUnit, 5> units{
    {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"ft", 304.8}, {"m", 1000.0}}};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

bool long_as_a_car(double mm) { return mm >= shortest_mm && mm <= longest_mm; }

}  // namespace

std::string unit_name(double mm) {
  for (const LengthUnit& unit : units)
    if (std::abs(unit.mm - mm) < 1e-6 * mm) return unit.name;
  return number(mm) + " mm";
}

LengthUnit guess_unit(double length) {
  LengthUnit best = units.front();
  const auto away = [&](const LengthUnit& unit) {
    return std::abs(std::log(length * unit.mm / usual_mm));
  };
  for (const LengthUnit& unit : units)
    if (away(unit) < away(best)) best = unit;
  if (!long_as_a_car(length * best.mm))
    throw std::invalid_argument("the scan is " + number(length) +
                                " units long, which is no car's length in mm, cm, m, inches or "
                                "feet; give its unit if it is a car");
  return best;
}

LengthUnit given_unit(double mm, double length) {
  if (!(mm > 0.0) || !std::isfinite(mm))
    throw std::invalid_argument("the unit must be a positive number of mm, not " + number(mm));
  if (!long_as_a_car(length * mm))
    throw std::invalid_argument("with a unit of " + number(mm) + " mm the scan is " +
                                number(length * mm) + " mm long, which is no car's length");
  return {unit_name(mm), mm};
}

}  // namespace bodyline::optimize
