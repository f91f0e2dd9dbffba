#pragma once

#include <Eigen/Core>
#include <vector>

/// Polylines, and what the paper does to them before it makes surfaces (Qin and Wright, section 2).
namespace bodyline::strokes {

using Points = std::vector<Eigen::Vector3d>;

/// Keeps the first point, then every point at least `threshold` from the one kept last. The last
/// point always stays; it takes the place of the one kept before when that is nearer. The result
/// has one point when nothing else is left.
Points filtered(const Points& points, double threshold);

/// Inserts midpoints of the longest chord, the first among equals, into the shorter polyline until
/// both have as many points (section 2.1). Both need two points or more.
void equalise(Points& a, Points& b);

double polyline_length(const Points& points);

/// Length from the first point to each point, over the whole length: 0 to 1. Throws
/// std::invalid_argument when the length is zero.
std::vector<double> chord_parameters(const Points& points);

/// i / (n - 1).
std::vector<double> index_parameters(std::size_t count);

/// The larger of two lengths; NaN when one is, so that what cannot be measured does not pass.
double larger(double a, double b);

bool all_finite(const Points& points);

/// The diagonal of the smallest upright box around the points of all polylines.
double diagonal(const std::vector<Points>& polylines);

}  // namespace bodyline::strokes
