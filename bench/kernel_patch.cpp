#include "bench/kernel_patch.hpp"

#include <random>

namespace bodyline::bench {

Patch bench_patch(const model::FaceTables& tables) {
  Patch patch{};
  const model::FaceRule& rule = tables.rule();
  for (int k = 0; k < Patch::nodes; ++k) {
    patch.parameters[k] = tables.rule_u().nodes[k];
    patch.weights[k] = rule.weights_u[k];
    for (int a = 0; a < 4; ++a) {
      for (int i = 0; i < Patch::points; ++i) {
        patch.basis[k][a][i] = rule.basis_u[(a * Patch::points + i) * Patch::nodes + k];
      }
    }
  }
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-20.0, 20.0);
  for (int i = 0; i < Patch::points; ++i) {
    for (int j = 0; j < Patch::points; ++j) {
      const double u = i / 3.0, v = j / 3.0;
      patch.net.push_back(1000.0 * u + 50.0 * v * v + noise(random));
      patch.net.push_back(700.0 * v - 100.0 * u * v + noise(random));
      patch.net.push_back(300.0 * u * u - 200.0 * v * v + 100.0 * u * v + noise(random));
    }
  }
  return patch;
}

}  // namespace bodyline::bench
