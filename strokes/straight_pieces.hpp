#pragma once

#include <Eigen/Core>
#include <vector>

namespace bodyline::strokes {

/// A run of samples, by the first and the last.
struct SampleRange {
  std::size_t first = 0, last = 0;

  bool operator==(const SampleRange&) const = default;
};

/// Largest distance of the samples of a range from the line between its ends, and which it is.
struct Bulge {
  double distance = 0.0;
  std::size_t sample = 0;
};
Bulge bulge(const std::vector<Eigen::Vector2d>& places, const SampleRange& range);

/// Cuts a pre-image where it is farthest from the line between its ends, again and again, until all
/// samples of every piece are within `straightness` of its line (section 2.3; the paper looks at
/// the middle only, which calls an S straight). Throws StrokeRejected after 12 levels.
std::vector<SampleRange> straight_pieces(const std::vector<Eigen::Vector2d>& places,
                                         double straightness);

/// How far along the line from the first to the last sample each one is: 0 to 1, strictly
/// increasing. Where the projections do not increase, the lengths along `points` are taken instead.
std::vector<double> line_fractions(const std::vector<Eigen::Vector2d>& places,
                                   const std::vector<Eigen::Vector3d>& points,
                                   const SampleRange& range);

}  // namespace bodyline::strokes
