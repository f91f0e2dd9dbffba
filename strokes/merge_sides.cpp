#include "strokes/merge_sides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bodyline::strokes {
namespace {

constexpr std::size_t most_sides = 4;
// Angles closer than this are equal: rounding must not choose the pair.
constexpr double equal_angle = 1e-9;

struct Pair {
  std::size_t first = 0;
  double angle = 0.0, shortest = 0.0;
};

Pair pair_at(const std::vector<Points>& loop, std::size_t first) {
  const Points &a = loop[first], &b = loop[(first + 1) % loop.size()];
  const Eigen::Vector3d chord_a = a.back() - a.front(), chord_b = b.back() - b.front();
  return {first, std::atan2(chord_a.cross(chord_b).norm(), chord_a.dot(chord_b)),
          std::min(polyline_length(a), polyline_length(b))};
}

bool better(const Pair& a, const Pair& b) {
  if (std::abs(a.angle - b.angle) > equal_angle) return a.angle < b.angle;
  return a.shortest < b.shortest;
}

}  // namespace

void merge_sides(std::vector<Points>& loop) {
  while (loop.size() > most_sides) {
    Pair best = pair_at(loop, 0);
    for (std::size_t k = 1; k < loop.size(); ++k) {
      const Pair pair = pair_at(loop, k);
      if (better(pair, best)) best = pair;
    }
    const std::size_t second = (best.first + 1) % loop.size();
    loop[best.first].insert(loop[best.first].end(), loop[second].begin() + 1, loop[second].end());
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(second));
  }
}

}  // namespace bodyline::strokes
