#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

/// Plane geometry of the domain: convex polygons, counter-clockwise.
namespace bodyline::strokes {

using Polygon = std::vector<Eigen::Vector2d>;

/// Places of the domain closer than this are one.
inline constexpr double same_place = 1e-7;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// Positive for a counter-clockwise polygon.
double area(const Polygon& polygon);

/// Whether every corner turns left, or goes straight on within rounding.
bool is_convex(const Polygon& polygon);

/// Smallest distance from the lines through the sides, positive inside.
double depth(const Polygon& polygon, const Eigen::Vector2d& place);

/// Part of a straight line, as parts of its length.
struct LinePart {
  double from = 0.0, to = 1.0;
};

/// The part of the line from a to b inside a convex polygon. None when it is shorter than
/// `same_place`, or follows a side.
std::optional<LinePart> part_inside(const Polygon& polygon, const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b);

/// Where on the line from a to b a place is nearest, 0 to 1.
double nearest_on_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       const Eigen::Vector2d& place);

}  // namespace bodyline::strokes
