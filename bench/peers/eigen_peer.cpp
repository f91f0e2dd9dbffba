#include <Eigen/Core>
#include <Eigen/Geometry>

#include "bench/peers/density.hpp"
#include "bench/peers/peers.hpp"

namespace bodyline::bench {
namespace {

using Eigen::Vector3d;

struct Jet {
  Vector3d d[6];  // S, Su, Sv, Suu, Suv, Svv
};

Jet jet_at(const Patch& patch, int ku, int kv) {
  const auto& bu = patch.basis[ku];
  const auto& bv = patch.basis[kv];
  Jet jet;
  for (Vector3d& d : jet.d) d.setZero();
  for (int i = 0; i < Patch::points; ++i) {
    Vector3d row[3] = {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
    for (int j = 0; j < Patch::points; ++j) {
      const Eigen::Map<const Vector3d> point(&patch.net[(i * Patch::points + j) * 3]);
      for (int b = 0; b < 3; ++b) row[b] += bv[b][j] * point;
    }
    jet.d[0] += bu[0][i] * row[0];
    jet.d[1] += bu[1][i] * row[0];
    jet.d[2] += bu[0][i] * row[1];
    jet.d[3] += bu[2][i] * row[0];
    jet.d[4] += bu[1][i] * row[1];
    jet.d[5] += bu[0][i] * row[2];
  }
  return jet;
}

}  // namespace

void eigen_jets(const Patch& patch, double* out) {
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku, out += jet_numbers) {
      const Jet jet = jet_at(patch, ku, kv);
      for (int q = 0; q < 6; ++q) Eigen::Map<Vector3d>(out + 3 * q) = jet.d[q];
    }
  }
}

void eigen_curvature(const Patch& patch, double* mean, double* gauss) {
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      const Jet jet = jet_at(patch, ku, kv);
      const auto c = curvature<double>(jet.d[1], jet.d[2], jet.d[3], jet.d[4], jet.d[5]);
      *mean++ = c.mean;
      *gauss++ = c.gauss;
    }
  }
}

double eigen_bending(const Patch& patch) {
  double total = 0.0;
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      const Jet jet = jet_at(patch, ku, kv);
      total += patch.weights[ku] * patch.weights[kv] *
               bending_density<double>(jet.d[1], jet.d[2], jet.d[3], jet.d[4], jet.d[5]);
    }
  }
  return total;
}

}  // namespace bodyline::bench
