#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "model/body_plan.hpp"

namespace bodyline::optimize {

/// A free side of a face: wheel arches, sill, lower edges.
struct Rim {
  int face = -1;  ///< index into the plan's faces of the stage
  model::Side side = model::Side::u0;
};

/// Which sides of the faces of a stage are rims of the body: no joint and no seam is there. By face
/// and by model::Side; joints' and corners' faces have none.
std::vector<std::array<bool, 4>> rims_of(const model::BodyPlan& plan, model::Stage stage);

/// The rims of a stage, face by face.
std::vector<Rim> rim_list(const model::BodyPlan& plan, model::Stage stage);

/// A point of a rim.
struct RimSample {
  Rim rim;
  double t = 0.0;            ///< parameter along the side
  double u = 0.0, v = 0.0;   ///< on the face
  Eigen::Vector3d position;  ///< mm
  Eigen::Vector3d normal;    ///< of the face, unit, outward
  Eigen::Vector3d outward;   ///< in the surface, away from the face, unit
  Eigen::Vector3d along;     ///< derivative of the position by t, mm
};

/// `count` points, at least one, of a rim evenly spaced in t, none at its ends; `face` is its face,
/// and `net` that face's.
std::vector<RimSample> rim_samples(const Rim& rim, const model::Face& face, const double* net,
                                   int count);

}  // namespace bodyline::optimize
