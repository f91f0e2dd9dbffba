#pragma once

#include <array>

namespace bodyline::model {

/// Jet of the Gregory function of section 8 at (u, v) in [0,1]^2,
///   g(u,v) = u (1-u)^2 v (1-v)^2 (u^2 - v^2) / (u^2 + v^2),
/// with all partial derivatives to third order, ordered by jet_index (surface.hpp). At the corner
/// (0,0), where g has no second derivatives, all ten are zero.
std::array<double, 10> blend_jet(double u, double v);

}  // namespace bodyline::model
