#pragma once

#include "strokes/net.hpp"

/// Frames of smooth nets. Along an edge with curve C and field D across it the surface has the
/// normal n of C' and D, and its form W has C'.W C' = n.C'' and C'.W D = n.D'. Every edge that ends
/// at a vertex keeps to the vertex's frame:
///   n.C' = 0,  n.C'' = C'.W C',  D = n x C',  D' = n x C'' + (C'.W D) n.
/// Then ribbons across neighbouring sides of a patch have the same twist at their corner, and all
/// patches around the vertex one tangent plane.
namespace bodyline::strokes {

/// Normal and second fundamental form of a patch; the form is zero where it has no normal.
Frame frame_of(const PatchJet& jet);

/// The frame at a point of an edge. What the edge leaves open, the curvature across it, is the mean
/// of that of its patches.
Frame frame_on_edge(const Net& net, const Edge& edge, double t);

/// The symmetric form in the plane square to `normal` with values a.W a = aa, a.W b = ab and
/// b.W b = bb for two vectors of the plane that are not parallel.
Eigen::Matrix3d form_from(const Eigen::Vector3d& normal, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, double aa, double ab, double bb);

/// The frame turned as little as possible so that a curve with the derivatives `first` and `second`
/// lies in the surface.
Frame frame_with(const Frame& frame, const Eigen::Vector3d& first, const Eigen::Vector3d& second);

/// The frame of two curves that cross, with derivatives `first` and `second` (new) and those of
/// `old_frame`'s edge; `mixed` is first.W old_first. Where they are almost parallel the old curve
/// gives way, as in `frame_with`.
Frame frame_of_crossing(const Frame& old_frame, const Eigen::Vector3d& first,
                        const Eigen::Vector3d& second, const Eigen::Vector3d& old_first,
                        const Eigen::Vector3d& old_second, double mixed);

}  // namespace bodyline::strokes
