#pragma once

namespace bodyline::strokes {

/// A line that meets an edge closer to its end than this part of its length meets the vertex
/// instead: else it would cut off a sliver.
inline constexpr double thin_part = 0.01;

/// The same where the vertex must not move.
inline constexpr double thinnest_part = 1e-4;

/// Shortest pre-image of a stroke.
inline constexpr double shortest_line = 1e-3;

}  // namespace bodyline::strokes
