#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "optimize/deviation.hpp"

namespace bodyline::optimize {

/// How far a part of a wheel arch's rim is from the rim that a scan shows.
struct ArchGap {
  bool front = false;  ///< which arch
  std::string part;    ///< "front", "top" or "rear"
  double gap = 0.0;    ///< mm, away from the wheel: positive where the rim ends short of the scan's
};

/// Compares the rims of both arches with where the scan ends beside them, seen from the side: from
/// outside towards the wheel the scan's points beside the rim end where two bands in a row have
/// hardly any. Parts where the points are too few to tell it to about 10 mm, and arches that are no
/// part of a circle, are left out. `deviation` is of `model` at its stage `body`.
std::vector<ArchGap> arch_gaps(const model::Model& model, const Deviation& deviation);

}  // namespace bodyline::optimize
