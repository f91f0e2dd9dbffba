#include "model/random.hpp"

#include <cmath>

namespace bodyline::model {

double Random::uniform() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }

// The remainder prefers small numbers by less than count / 2^64.
std::uint64_t Random::below(std::uint64_t count) { return engine_() % count; }

// True with probability exp(-exponent), exponent in [0, 1]: a run of falling uniforms that starts
// below it has n members or more with probability exponent^n / n! (von Neumann 1951).
bool Random::chance_of_decay(double exponent) {
  bool even = true;
  double last = exponent;
  for (double next = uniform(); next < last; next = uniform()) {
    last = next;
    even = !even;
  }
  return even;
}

// C. Karney, Sampling exactly from the normal distribution, 2016, algorithm N: whole part k and
// fraction x with density exp(-k/2) exp(-k(k-1)/2) exp(-x(2k+x)/2) = exp(-(k+x)^2/2).
double Random::normal() {
  while (true) {
    int whole = 0;
    while (chance_of_decay(0.5)) ++whole;
    bool taken = true;
    for (int trial = 0; taken && trial < whole * (whole - 1); ++trial) {
      taken = chance_of_decay(0.5);
    }
    if (!taken) continue;
    const double fraction = uniform();
    const double exponent = fraction * (2.0 * whole + fraction) / (2.0 * whole + 2.0);
    for (int trial = 0; taken && trial <= whole; ++trial) taken = chance_of_decay(exponent);
    if (!taken) continue;
    const double size = whole + fraction;
    return below(2) == 0 ? size : -size;
  }
}

Eigen::Vector3d Random::direction() {
  while (true) {
    Eigen::Vector3d point;
    for (int c = 0; c < 3; ++c) point[c] = 2.0 * uniform() - 1.0;
    const double squared = point.squaredNorm();
    if (squared > 1e-6 && squared <= 1.0) return point / std::sqrt(squared);
  }
}

}  // namespace bodyline::model
