#pragma once

#include "model/connect.hpp"

namespace bodyline::model {

/// Curve ends that must coincide closer than this, mm.
inline constexpr double closing_tolerance = 1e-9;

/// First part of `connect`: degrees and vertices of all patches; checks that sides are known, that
/// opposite sides have the same degree, that patch corners close and that central patches are
/// mirror symmetric.
void connect_vertices(const Model& model, Connectivity& links);

}  // namespace bodyline::model
