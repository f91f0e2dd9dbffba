#include <ceres/jet.h>

#include "bench/peers/density.hpp"
#include "bench/peers/generic_vector.hpp"
#include "bench/peers/peers.hpp"

namespace bodyline::bench {
namespace {

constexpr int variables = 48;
constexpr int entries = 5;  // Su, Sv, Suu, Suv, Svv
constexpr int order_u[entries] = {1, 0, 2, 1, 0};
constexpr int order_v[entries] = {0, 1, 0, 1, 2};

template <class Real>
Real density_of(const GenericVector<Real>* d) {
  return bending_density<Real>(d[0], d[1], d[2], d[3], d[4]);
}

}  // namespace

double ceres_bending_48(const Patch& patch, double* gradient) {
  using Real = ceres::Jet<double, variables>;
  Real net[variables];
  for (int k = 0; k < variables; ++k) net[k] = Real(patch.net[k], k);
  Real total(0.0);
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      GenericVector<Real> d[entries];
      for (int q = 0; q < entries; ++q) {
        d[q] =
            evaluate(net, patch.basis[ku][order_u[q]], patch.basis[kv][order_v[q]], Patch::points);
      }
      total += patch.weights[ku] * patch.weights[kv] * density_of(d);
    }
  }
  Eigen::Map<Eigen::Matrix<double, variables, 1>>{gradient} = total.v;
  return total.a;
}

double ceres_bending_15(const Patch& patch, double* gradient) {
  using Real = ceres::Jet<double, 3 * entries>;
  Eigen::Map<Eigen::Matrix<double, variables, 1>> result(gradient);
  result.setZero();
  double total = 0.0;
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      GenericVector<Real> d[entries];
      for (int q = 0; q < entries; ++q) {
        const GenericVector<double> value = evaluate(patch.net.data(), patch.basis[ku][order_u[q]],
                                                     patch.basis[kv][order_v[q]], Patch::points);
        d[q] = {Real(value.x, 3 * q), Real(value.y, 3 * q + 1), Real(value.z, 3 * q + 2)};
      }
      const double weight = patch.weights[ku] * patch.weights[kv];
      const Real density = weight * density_of(d);
      total += density.a;
      for (int i = 0; i < Patch::points; ++i) {
        for (int j = 0; j < Patch::points; ++j) {
          double* point = gradient + (i * Patch::points + j) * 3;
          for (int q = 0; q < entries; ++q) {
            const double factor = patch.basis[ku][order_u[q]][i] * patch.basis[kv][order_v[q]][j];
            for (int c = 0; c < 3; ++c) point[c] += factor * density.v[3 * q + c];
          }
        }
      }
    }
  }
  return total;
}

}  // namespace bodyline::bench
