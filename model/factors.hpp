#pragma once

/// Factors between units, and between the half of a body that is computed and the whole.
namespace bodyline::model {

inline constexpr double mm_per_m = 1e3;
inline constexpr double square_mm_per_square_m = 1e6;
inline constexpr double cubic_mm_per_cubic_m = 1e9;

/// What a sum over the left half counts in the whole body: side faces stand for their mirror images
/// too, and of central faces (`summed_range`) only the left half is summed.
inline constexpr double both_halves = 2.0;

}  // namespace bodyline::model
