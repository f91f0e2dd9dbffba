#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/evaluator.hpp"

namespace bodyline::model {

/// d nets / d variables at the evaluator's last x: 3 * point_count rows (xyz at the plan's
/// offsets), evaluator.size() columns. Only the rows whose number is among `wanted` are set, the
/// others are 0; each costs one pullback of the construction.
Eigen::MatrixXd net_jacobian(Evaluator& evaluator, const std::vector<Eigen::Index>& wanted);

}  // namespace bodyline::model
