#pragma once

#include <limits>
#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/scan.hpp"

namespace bodyline::optimize {

/// How to align a scan.
struct AlignOptions {
  double unit_mm = 0.0;                       ///< mm per unit of the scan; 0: guessed from its size
  std::optional<model::Pose> pose;            ///< taken as it is, unit included, and only judged
  std::string reference = "the start model";  ///< what the start model is called in sentences
  unsigned seed = 1;  ///< of the draw of points; the result hardly depends on it
};

/// Which side of the car a scan leaves out.
enum class MissingSide { none, left, right };

/// Which end of the car a scan leaves out, or both.
enum class MissingEnd { none, front, rear, both };

/// Where a scan lies.
struct AlignResult {
  model::Pose pose;
  std::string unit;    ///< "mm", "cm", "in", "ft", "m", or the number of mm
  double fit = 0.0;    ///< share of the points on the start model stretched to the scan, 0 to 1
  double doubt = 0.0;  ///< fit of the best other orientation over the fit of this one
  double symmetry_mm =
      0.0;                ///< median distance of the mirror image from the scan; 0: one side only
  double cover = 0.0;     ///< how well the points cover the stretched start model, without a
                          ///< missing side, 0 to about 1
  double coverage = 0.0;  ///< share of its two sides with a point near, 0 to 1
  double ground =
      0.0;  ///< share of the points on the ground and lower, set aside; 0: none was found
  /// Points lower than this at the pose, mm, are none of the car's; without ground, all are higher.
  double floor_mm = -std::numeric_limits<double>::infinity();
  MissingSide missing = MissingSide::none;
  MissingEnd missing_end = MissingEnd::none;
  model::Scan beyond_end;  ///< what the stretched start model has where an end is missing, in
                           ///< the scan's coordinates; empty else
  bool pose_is_doubtful = false;  ///< at a given pose the scan does not lie like a car
  std::string words;              ///< all this for the user, in sentences
  std::string warning;            ///< of them what must not be missed; empty when all is well
};

/// Finds where a scan of a car in any orientation, position and unit lies on a start model: which
/// way is up and which way it drives, its plane of symmetry at y = 0, and the shift along the plane
/// that brings it closest to the start model as it is. The car may be longer, wider or higher than
/// the start model by up to 40 %; the pose's scale is only the unit. Outliers, ground, wheels and
/// mirrors are ignored, and one side or one half of the length may be missing. The same input gives
/// the same bits with any number of threads. Throws std::invalid_argument, with one sentence, for
/// too few points and for what is not a car.
AlignResult align_scan(const model::Scan& scan, const model::Model& start,
                       const AlignOptions& options = {});

}  // namespace bodyline::optimize
