#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/model.hpp"

namespace bodyline::sketch {

/// Degrees wanted of the curves of a body.
struct CurveDegrees {
  std::optional<int> all;              ///< of every curve that is not named below
  std::map<std::string, int> by_name;  ///< of single curves
};

/// The model with its curves in other degrees. Opposite sides of a patch have one degree, so the
/// curves opposite to a named one, and those opposite to them, follow it. To a higher degree curves
/// are raised exactly; to a lower one they are fitted between their ends, by least squares at even
/// parameters. Patches whose degree changes get neutral shape parameters. Throws
/// std::invalid_argument for a name that is no curve's, a degree outside 2 to 9, and for names that
/// lie opposite each other with different degrees.
model::Model with_degrees(model::Model model, const CurveDegrees& degrees);

/// The points of a Bezier curve in another degree, as with_degrees has it.
std::vector<Eigen::Vector3d> in_degree(std::vector<Eigen::Vector3d> points, int degree);

}  // namespace bodyline::sketch
