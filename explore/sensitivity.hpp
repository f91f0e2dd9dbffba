#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// How much each coordinate of the unit cube matters to a result, from the designs of
/// sampler_sensitivity.hpp.
namespace bodyline::explore {

/// A number and half the width of its 95 % interval, from resampling the design's groups with
/// replacement.
struct Estimate {
  double value = 0.0;
  double half_width = 0.0;
};

/// Elementary effects of one coordinate: changes of the result over the length of a step in the
/// cube.
struct MorrisEffect {
  Estimate mu_star;    ///< mean of their sizes
  double mu = 0.0;     ///< mean
  double sigma = 0.0;  ///< standard deviation: how much they depend on where in the cube one is
};

struct MorrisResult {
  std::vector<MorrisEffect> effects;  ///< of each coordinate
  std::size_t used = 0, all = 0;      ///< trajectories; those with a result that is not finite are
                                      ///< left out
};

/// `points` are those of a Morris design (rows of `dimension` coordinates), `results` one number
/// each.
MorrisResult morris_effects(std::span<const double> points, std::span<const double> results,
                            int dimension);

/// Shares of the variance of the result.
struct SobolIndices {
  std::vector<Estimate> first;  ///< due to a coordinate alone (Saltelli and others, "Variance based
                                ///< sensitivity analysis of model output", 2010, table 2 b)
  std::vector<Estimate> total;  ///< due to it alone or with others (Jansen; there table 2 f)
  std::vector<Estimate> second;   ///< due to two together, at i * dimension + j for i < j; empty
                                  ///< without rows for it
  std::size_t used = 0, all = 0;  ///< points of the sequence; those with a result that is not
                                  ///< finite are left out
};

/// `results` are those of a Saltelli design, one number each.
SobolIndices sobol_indices(std::span<const double> results, int dimension, bool second_order);

}  // namespace bodyline::explore
