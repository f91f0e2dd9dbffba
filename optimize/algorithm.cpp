#include "optimize/algorithm.hpp"

#include <array>
#include <stdexcept>

namespace bodyline::optimize {
namespace {

struct Entry {
  Algorithm algorithm;
  const char* name;
  bool gradient;
  bool global;
};

constexpr std::array<Entry, 9> entries{{
    {Algorithm::nlopt_lbfgs, "nlopt-lbfgs", true, false},
    {Algorithm::nlopt_mma, "nlopt-mma", true, false},
    {Algorithm::nlopt_ccsaq, "nlopt-ccsaq", true, false},
    {Algorithm::nlopt_slsqp, "nlopt-slsqp", true, false},
    {Algorithm::nlopt_cobyla, "nlopt-cobyla", false, false},
    {Algorithm::nlopt_crs, "nlopt-crs", false, true},
    {Algorithm::nlopt_direct, "nlopt-direct", false, true},
    {Algorithm::ceres_lbfgs, "ceres-lbfgs", true, false},
    {Algorithm::ceres_lm, "ceres-lm", true, false},
}};

const Entry& entry_of(Algorithm algorithm) {
  for (const Entry& entry : entries) {
    if (entry.algorithm == algorithm) return entry;
  }
  throw std::invalid_argument("Unknown optimization algorithm.");
}

}  // namespace

std::string algorithm_name(Algorithm algorithm) { return entry_of(algorithm).name; }

Algorithm algorithm_from_name(const std::string& name) {
  std::string known;
  for (const Entry& entry : entries) {
    if (name == entry.name) return entry.algorithm;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw std::invalid_argument("Unknown algorithm '" + name + "'; the algorithms are " + known +
                              ".");
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

bool uses_gradient(Algorithm algorithm) { return entry_of(algorithm).gradient; }

bool is_global(Algorithm algorithm) { return entry_of(algorithm).global; }

}  // namespace bodyline::optimize
