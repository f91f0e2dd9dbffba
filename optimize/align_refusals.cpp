#include "optimize/align_refusals.hpp"

#include <stdexcept>

#include "optimize/align_register.hpp"

namespace bodyline::optimize {
namespace {

// Above the largest share of a car's points in one plane, ground included; below any sheet's.
constexpr double flat_share = 0.85;
// Cars have 0.33 to 0.62, one side of a car 0.2, one half of its length up to 0.85; a sphere and a
// bunny have 1.
constexpr double most_width = 0.93;
constexpr double least_height = 0.08;

// Measured: fit + cover is 0.80 to 2 for seven cars on three start models, and down to 0.62 with
// outliers, wheels, ground and holes together; a bunny, a teapot, tables, people and open boxes
// reach 0.2 to 0.57, also when they are stretched to a car's box.
constexpr double least_evidence = 0.59;
// Ellipsoids, houses and boats of a car's size reach 0.60 to 0.73, but fit as well back to front
// (0.97 to 1); cars with so little evidence stay below 0.96.
constexpr double clear_evidence = 0.78;
constexpr double most_doubt = 0.965;
// Half a car has over 1.1 on half of the start model; what is no car reaches 0.2 to 0.52.
constexpr double least_half_evidence = 0.8;
constexpr double half_margin = 0.1;  // half a model is covered more easily than a whole one
// A half-cylinder fits well when the start model is stretched without limit.
constexpr double at_limit = 0.99;

}  // namespace

void refuse_flat(const Plane& plane) {
  if (plane.share > flat_share) throw std::invalid_argument("the scan is a flat plane, not a car");
}

void refuse_by_box(const Eigen::Vector3d& extents) {
  if (extents[1] > most_width * extents[0])
    throw std::invalid_argument(
        "the scan is nearly as wide as it is long, which no car is; give its pose if it is a part "
        "of one");
  if (extents[2] < least_height * extents[0])
    throw std::invalid_argument("the scan is a thin sheet, not a car");
}

bool is_a_car(const FitEvidence& evidence) {
  const double sum = evidence.fit + evidence.cover;
  return sum >= least_evidence && evidence.length_stretch <= at_limit * most_stretch[0] &&
         (sum >= clear_evidence || evidence.doubt <= most_doubt);
}

bool is_clearly_a_car(const FitEvidence& evidence) {
  return is_a_car(evidence) && evidence.fit + evidence.cover >= clear_evidence;
}

bool is_rather_half_a_car(const FitEvidence& half, const FitEvidence& other) {
  const double sum = half.fit + half.cover;
  return is_a_car(half) && sum >= least_half_evidence &&
         sum > other.fit + other.cover + half_margin;
}

void refuse_by_fit(const FitEvidence& evidence) {
  if (is_a_car(evidence)) return;
  if (evidence.fit + evidence.cover < least_evidence ||
      evidence.length_stretch > at_limit * most_stretch[0])
    throw std::invalid_argument(
        "the scan does not have the shape of a car; give its pose if it is one");
  throw std::invalid_argument(
      "the front of the scan cannot be told from its rear or its top from its bottom; give its "
      "pose if it is a car");
}

}  // namespace bodyline::optimize
