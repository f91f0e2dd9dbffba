#pragma once

#include <string>

namespace bodyline::model {

/// The shortest decimal that reads back as the same double, so that different numbers never look
/// alike; whole numbers without an exponent; "nan" and "inf" as such.
std::string number_text(double value);

}  // namespace bodyline::model
