#pragma once

namespace bodyline::io {

/// 1, 2 or 5 times a power of ten, the smallest that is not below a positive value.
double rounded_up(double value);

}  // namespace bodyline::io
