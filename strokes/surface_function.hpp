#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "model/spline_curve.hpp"
#include "strokes/patch_shape.hpp"

namespace bodyline::strokes {

/// A smooth surface over the whole domain of a net: the point of a place with derivatives by its
/// coordinates, x for s and y for t.
using SurfaceFunction = std::function<PatchJet(const Eigen::Vector2d& place)>;

/// The surface that a closed loop of three or four curves spans over base_domain(): side k of the
/// domain is curve k. Four sides make the bilinearly blended Coons patch, three the symmetric
/// blend (P_1 + P_2 + P_3 - L) / 2, where P_i joins the other two sides by straight lines that lie
/// over parallels to side i, and L is the flat triangle. Two derivatives are continuous where those
/// of the curves are.
SurfaceFunction blended_surface(const std::vector<model::SplineCurve>& loop);

}  // namespace bodyline::strokes
