#pragma once

#include <string>

namespace bodyline::optimize {

/// A unit of length that scans come in.
struct LengthUnit {
  std::string name;  ///< "mm", "cm", "in", "ft", "m", or the number of mm
  double mm = 1.0;
};

/// The name of the unit of `mm` millimetres.
std::string unit_name(double mm);

/// The unit in which a scan of this length is as long as a car. Throws std::invalid_argument when
/// it is not in any.
LengthUnit guess_unit(double length);

/// The unit of `mm` millimetres. Throws std::invalid_argument when it is not positive, or when a
/// scan of this length would not be as long as a car.
LengthUnit given_unit(double mm, double length);

}  // namespace bodyline::optimize
