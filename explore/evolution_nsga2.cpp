#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "explore/evolution.hpp"

namespace bodyline::explore {
namespace {

using pagmo::vector_double;

// The usual ones; a child changes one coordinate on average.
constexpr double crossover = 0.9, crossover_index = 15.0, mutation_index = 20.0;

// The cube with its objectives, for pagmo, which never evaluates a single point of it.
struct Cube {
  ObjectiveBatch* objectives = nullptr;

  vector_double fitness(const vector_double& point) const {
    vector_double values(vector_double::size_type(objectives->objectives()));
    objectives->evaluate(point, values);
    return values;
  }
  std::pair<vector_double, vector_double> get_bounds() const {
    const auto d = vector_double::size_type(objectives->dimension());
    return {vector_double(d, 0.0), vector_double(d, 1.0)};
  }
  vector_double::size_type get_nobj() const {
    return vector_double::size_type(objectives->objectives());
  }
};

struct Batch {
  vector_double operator()(const pagmo::problem& problem, const vector_double& points) const {
    ObjectiveBatch& objectives = *problem.extract<Cube>()->objectives;
    vector_double values(points.size() / std::size_t(objectives.dimension()) *
                         std::size_t(objectives.objectives()));
    objectives.evaluate(points, values);
    return values;
  }
};

pagmo::population first_population(ObjectiveBatch& objectives, const std::vector<double>& points) {
  const std::size_t d = std::size_t(objectives.dimension()),
                    m = std::size_t(objectives.objectives()), count = points.size() / d;
  std::vector<double> values(count * m);
  objectives.evaluate(points, values);
  pagmo::population population(pagmo::problem(Cube{&objectives}), 0u, 0u);
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = [k](const std::vector<double>& all, std::size_t size) {
      return vector_double(all.begin() + std::ptrdiff_t(k * size),
                           all.begin() + std::ptrdiff_t((k + 1) * size));
    };
    population.push_back(row(points, d), row(values, m));
  }
  return population;
}

}  // namespace

Population evolve_nsga2(ObjectiveBatch& objectives, const EvolutionOptions& options) {
  if (options.before && !options.before(0)) return {};
  pagmo::population population = first_population(objectives, options.first);
  pagmo::nsga2 nsga2(1u, crossover, crossover_index, 1.0 / objectives.dimension(), mutation_index,
                     options.seed);
  nsga2.set_bfe(pagmo::bfe(Batch{}));
  for (int generation = 1; generation <= options.generations; ++generation) {
    if (options.before && !options.before(generation)) break;
    population = nsga2.evolve(population);
  }
  Population last;
  for (const vector_double& x : population.get_x())
    last.points.insert(last.points.end(), x.begin(), x.end());
  for (const vector_double& f : population.get_f())
    last.values.insert(last.values.end(), f.begin(), f.end());
  return last;
}

}  // namespace bodyline::explore
