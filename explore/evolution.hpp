#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace bodyline::explore {

/// Several objectives of points of the unit cube, all to be small, evaluated many points at a time.
class ObjectiveBatch {
 public:
  virtual ~ObjectiveBatch() = default;
  virtual int dimension() const = 0;
  virtual int objectives() const = 0;

  /// One row of coordinates for each point to one row of objectives, all finite.
  virtual void evaluate(std::span<const double> points, std::span<double> values) = 0;
};

struct EvolutionOptions {
  int generations = 1;  ///< after the first population
  std::uint32_t seed = 1;
  std::vector<double> first;  ///< the first population: a row of coordinates each
  /// Called before every generation with its number, from 0 for the first population; false ends
  /// the evolution. May be empty.
  std::function<bool(int generation)> before;
};

/// The last generation: a row of coordinates and a row of objectives each.
struct Population {
  std::vector<double> points, values;
};

/// NSGA-II of Deb, Pratap, Agarwal and Meyarivan, 2002, as pagmo has it; every generation is one
/// batch. The population must be a multiple of 4, 8 or more.
Population evolve_nsga2(ObjectiveBatch& objectives, const EvolutionOptions& options);

/// MOEA/D with differential evolution of Li and Zhang, 2009, from pagmo's parts, but in batches: 24
/// children are bred from the population as it is and evaluated at once before any takes its place.
/// (pagmo's own MOEA/D in version 2.18 evaluates child by child, on one thread.)
Population evolve_moead(ObjectiveBatch& objectives, const EvolutionOptions& options);

}  // namespace bodyline::explore
