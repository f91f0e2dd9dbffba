#pragma once

namespace bodyline::model {

/// Largest coordinate of a model, and of what it is to meet, mm; a car that is 1 km long is a
/// mistake in the units.
inline constexpr double largest_coordinate = 1e6;

}  // namespace bodyline::model
