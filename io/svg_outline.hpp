#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bodyline::io {

/// A drawn outline, a point every few mm with its signed distance (mm, `range` as for svg_dots),
/// over the polygons of a body's silhouette, as an inline SVG to scale. Pictures are as a view
/// shows them, y up. Empty when there is neither.
std::string svg_outline(const std::string& view,
                        const std::vector<std::vector<Eigen::Vector2d>>& silhouette,
                        const std::vector<Eigen::Vector2d>& points,
                        const std::vector<double>& distances, double range);

}  // namespace bodyline::io
