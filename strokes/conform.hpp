#pragma once

#include <functional>

#include "strokes/net_edit.hpp"

namespace bodyline::strokes {

/// Normals along an edge, unit, by its parameter.
using NormalField = std::function<Eigen::Vector3d(double)>;

/// The normals of an edge as it is.
NormalField edge_normals(const Edge& edge);

/// Bends an edge at the ends that lie at its vertices so that it ends in their points and keeps to
/// their frames (frame.hpp): its curve gets a polynomial of degree 5 that vanishes with two
/// derivatives at the other end, its field across is made anew from `normals`, turned into the
/// frames at the ends.
void conform(NetEdit& edit, int edge, const NormalField& normals);

/// The field D across a curve: at every break of the curve N x C', with its derivative, where N
/// follows `normals` and is made to agree with the frames at both ends; cubic in between.
model::SplineCurve across_field(const model::SplineCurve& curve, const NormalField& normals,
                                const Frame& begin, const Frame& end);

}  // namespace bodyline::strokes
