#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/scan.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// Distances of a scan's points from a body, mm, without sign.
struct Distances {
  double median = 0.0, p90 = 0.0, p99 = 0.0;
  double trimmed_rms = 0.0;  ///< root mean square of the nearest 90 %
};

/// One face of the left half or of the middle; points of the right half count for their mirror
/// images.
struct FaceDeviation {
  std::string name;
  std::size_t points = 0;
  Distances distances;
  double mean = 0.0;  ///< signed, positive outside of the body
  double seen = 0.0;  ///< share of the face that has points of the scan near it
};

struct Deviation {
  Distances distances;
  std::vector<FaceDeviation> faces;
  std::vector<std::string> unseen_patches;  ///< patches of which the scan hardly shows anything
  model::Scan scan;                         ///< the points looked at: folded, in the model's frame
  std::vector<Match> matches;               ///< of its points
};

struct DeviationOptions {
  model::Stage stage = model::Stage::body;
  std::size_t most_points = 200000;
  double near = 30.0;       ///< points so near show a face, mm
  double least_seen = 0.2;  ///< share of a patch that must be seen
};

/// Compares a scan with a body. Throws model::ModelError when the model cannot be built and
/// std::invalid_argument for a scan without points.
Deviation measure_deviation(const model::Model& model, const model::Scan& scan,
                            const model::Pose& pose, const DeviationOptions& options = {});

}  // namespace bodyline::optimize
