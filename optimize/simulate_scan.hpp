#pragma once

#include <cstdint>
#include <string>

#include "model/model.hpp"
#include "model/scan.hpp"

namespace bodyline::optimize {

/// What a simulated scanner does not see.
enum class Missing {
  none,
  left,  ///< no point has y < 0
  holes  ///< random balls are empty; half of the points are gone
};

const char* missing_name(Missing missing);

/// Throws std::invalid_argument for a name that is none.
Missing missing_from_name(const std::string& name);

/// A scanner. All of it acts on the model in its own frame; the pose comes last.
struct SimulateOptions {
  std::size_t points = 200'000;  ///< 100 to 50 million, before some go missing
  double noise_mm = 1.0;         ///< standard deviation along each axis, 0 to 1000
  double outliers = 0.0;         ///< part of the points that lie anywhere, 0 to 0.9
  std::uint64_t seed = 1;
  Missing missing = Missing::none;
  model::Pose pose = {};  ///< of the scan: its points are x with pose(x) on the body
};

/// Points on the outside of a body, both sides, uniform by area, with the faces' normals. Outliers
/// are uniform in the bounding box of the points enlarged by 20 %, with normals in any direction.
/// The same body and options give the same bits. Throws std::invalid_argument for options out of
/// their bounds and for a pose that is none, ModelError for a model that cannot be built.
model::Scan simulate_scan(const model::Model& model, const SimulateOptions& options = {});

}  // namespace bodyline::optimize
