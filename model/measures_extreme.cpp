#include "model/measures_extreme.hpp"

#include <algorithm>
#include <limits>

namespace bodyline::model {
namespace {

constexpr double smallest_step = 1e-9;
constexpr int most_moves = 500;  // at one step length; a curved ridge is followed no further

using Function = std::function<double(double, double)>;

bool try_point(const Function& f, double u, double v, Extreme& best) {
  const double value = f(u, v);
  if (!(value > best.value)) return false;
  best = {u, v, value};
  return true;
}

// Moves to the best of the eight neighbours; false when none is better.
bool move_once(const Function& f, double step, Extreme& best) {
  const Extreme from = best;
  bool moved = false;
  for (int a = -1; a <= 1; ++a) {
    for (int b = -1; b <= 1; ++b) {
      const double u = std::clamp(from.u + a * step, 0.0, 1.0);
      const double v = std::clamp(from.v + b * step, 0.0, 1.0);
      if (u == from.u && v == from.v) continue;
      if (try_point(f, u, v, best)) moved = true;
    }
  }
  return moved;
}

}  // namespace

Extreme largest_value(const Function& f, int cells) {
  Extreme best{0.0, 0.0, -std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) try_point(f, double(i) / cells, double(j) / cells, best);
  }
  for (double step = 0.5 / cells; step > smallest_step; step *= 0.5) {
    int moves = 0;
    while (moves < most_moves && move_once(f, step, best)) ++moves;
  }
  return best;
}

}  // namespace bodyline::model
