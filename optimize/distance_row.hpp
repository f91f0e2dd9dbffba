#pragma once

#include "model/body_plan.hpp"
#include "optimize/net_rows.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// The signed distance of a point from the tangent plane at its foot, mm, outside positive, as a
/// function of all numbers of the face where it was matched (its net and its Gregory coefficient);
/// the foot's (u, v) and the unit `normal` are held. `nets` are those of the match.
NetRow distance_row(const model::Face& face, const Match& match, const Eigen::Vector3d& normal,
                    const double* nets);

}  // namespace bodyline::optimize
