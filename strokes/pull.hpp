#pragma once

#include "strokes/net_edit.hpp"

/// How earlier curves give way to a new stroke that passes them at a distance (section 3, step 4).
namespace bodyline::strokes {

/// How a move fades along an edge.
enum class Fade {
  linear,  ///< as the paper has it: w, up to the ends of the edge
  /// Without kinks: w^2 (3 - 2 w); where the edge was not drawn up to where it was, where it was
  /// over `move_spread` times the move.
  smooth
};

/// How far a smooth move of what was drawn reaches to either side along an edge, in times the move.
inline constexpr double move_spread = 8.0;

/// Moves an edge so that it passes through its point at t plus `delta`: every point by w delta
/// (faded), w = tau / t before t and (1 - tau) / (1 - t) behind. The ends stay.
void pull_edge(NetEdit& edit, int edge, double t, const Eigen::Vector3d& delta,
               Fade fade = Fade::linear);

/// Moves a vertex by `delta`, and the edges that meet there by w delta, where w falls linearly from
/// 1 at the vertex to 0 at their other ends.
void pull_vertex(NetEdit& edit, int vertex, const Eigen::Vector3d& delta, Fade fade = Fade::linear);

/// Whether such a move reaches what was drawn of an edge; `t` is 0 or 1 for a move of a vertex.
bool moves_drawn(const Edge& edge, double t, Fade fade);

}  // namespace bodyline::strokes
