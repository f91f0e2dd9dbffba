#pragma once

#include <vector>

#include "model/silhouette_curves.hpp"

namespace bodyline::model {

/// The outline that the pieces of a silhouette's left half make together with their mirror images:
/// polygons in the picture, mm, closed (the last point is the first) unless a piece of more than
/// `gap` mm is missing.
std::vector<std::vector<Eigen::Vector2d>> silhouette_outline(
    const std::vector<SilhouetteCurve>& pieces, View view, double gap = 20.0);

/// A point's place in the other half of a view's picture; the same in a view from the side.
Eigen::Vector2d mirrored_picture(View view, const Eigen::Vector2d& picture);

}  // namespace bodyline::model
