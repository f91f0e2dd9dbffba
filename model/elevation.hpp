#pragma once

#include "model/bernstein.hpp"
#include "model/isa_namespace.hpp"
#include "model/unrolled.hpp"
#include "model/vec3.hpp"

/// Degree elevation and products of Bezier rows, with their pullbacks. All weights are tables made
/// by the compiler.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Highest degree of the curves of a body.
inline constexpr int max_patch_degree = 9;
/// Highest degree of a patch's net in one direction: some families need more than their curves.
inline constexpr int max_net_degree = 11;

/// k / n and (n - k) / n, 0 <= k <= n, 1 <= n <= max_net_degree + 1.
struct FractionTable {
  double value[max_net_degree + 2][max_net_degree + 2];  ///< [n][k]
  double rest[max_net_degree + 2][max_net_degree + 2];
};
consteval FractionTable make_fractions() {
  FractionTable table{};
  for (int n = 1; n <= max_net_degree + 1; ++n) {
    for (int k = 0; k <= n; ++k) {
      table.value[n][k] = double(k) / n;
      table.rest[n][k] = double(n - k) / n;
    }
  }
  return table;
}
inline constexpr FractionTable fractions = make_fractions();

/// weight[k][i]: coefficient of point i of degree N in point k of degree N + R.
template <int N, int R>
struct ElevationTable {
  double weight[N + R + 1][N + 1];
};
template <int N, int R>
consteval ElevationTable<N, R> make_elevation() {
  ElevationTable<N, R> table{};
  for (int k = 0; k <= N + R; ++k) {
    for (int i = 0; i <= N; ++i) {
      table.weight[k][i] = binomial(N, i) * binomial(R, k - i) / binomial(N + R, k);
    }
  }
  return table;
}
template <int N, int R>
inline constexpr ElevationTable<N, R> elevation = make_elevation<N, R>();

/// weight[i][j]: coefficient of f_i g_j, of degrees P and Q, in point i + j of the product.
template <int P, int Q>
struct ProductTable {
  double weight[P + 1][Q + 1];
};
template <int P, int Q>
consteval ProductTable<P, Q> make_product() {
  ProductTable<P, Q> table{};
  for (int i = 0; i <= P; ++i) {
    for (int j = 0; j <= Q; ++j) {
      table.weight[i][j] = binomial(P, i) * binomial(Q, j) / binomial(P + Q, i + j);
    }
  }
  return table;
}
template <int P, int Q>
inline constexpr ProductTable<P, Q> product = make_product<P, Q>();

/// raised (N + R + 1 points) = the same curve as row (N + 1 points).
template <int N, int R, class Real>
void elevate(const Vec3<Real>* row, Vec3<Real>* raised) {
  unrolled<0, N + R>([&](auto k) {
    constexpr int first = k > R ? k - R : 0, last = k < N ? k : N;
    constexpr const double* weight = elevation<N, R>.weight[k];
    Vec3<Real> sum = scaled(weight[first], row[first]);
    unrolled<first + 1, last>([&](auto i) { sum += scaled(weight[i], row[i]); });
    raised[k] = sum;
  });
}

/// Pullback of elevate: adds to row_bar.
template <int N, int R, class Real>
void elevate_pullback(const Vec3<Real>* raised_bar, Vec3<Real>* row_bar) {
  unrolled<0, N>([&](auto i) {
    Vec3<Real> sum = row_bar[i];
    unrolled<i, i + R>([&](auto k) { sum += scaled(elevation<N, R>.weight[k][i], raised_bar[k]); });
    row_bar[i] = sum;
  });
}

/// raised (n + 2 points) = the same curve as row (n + 1 points), n <= max_net_degree.
template <class Real>
void elevate_once(int n, const Vec3<Real>* row, Vec3<Real>* raised) {
  const double *share = fractions.value[n + 1], *rest = fractions.rest[n + 1];
  raised[0] = row[0];
  for (int k = 1; k <= n; ++k) raised[k] = scaled(share[k], row[k - 1]) + scaled(rest[k], row[k]);
  raised[n + 1] = row[n];
}

/// Pullback of elevate_once: adds to row_bar.
template <class Real>
void elevate_once_pullback(int n, const Vec3<Real>* raised_bar, Vec3<Real>* row_bar) {
  const double *share = fractions.value[n + 1], *rest = fractions.rest[n + 1];
  for (int k = 0; k <= n; ++k) {
    row_bar[k] += scaled(rest[k], raised_bar[k]) + scaled(share[k + 1], raised_bar[k + 1]);
  }
}

/// The same curve `times` degrees higher, in place: n + 1 points become n + times + 1.
template <class Real>
void elevate_times(int n, int times, Vec3<Real>* row) {
  for (int degree = n; degree < n + times; ++degree) {
    const double *share = fractions.value[degree + 1], *rest = fractions.rest[degree + 1];
    row[degree + 1] = row[degree];
    for (int k = degree; k > 0; --k)
      row[k] = scaled(share[k], row[k - 1]) + scaled(rest[k], row[k]);
  }
}

/// Pullback of elevate_times, in place: the adjoints of n + times + 1 points become those of n + 1.
template <class Real>
void elevate_times_pullback(int n, int times, Vec3<Real>* bar) {
  for (int degree = n + times - 1; degree >= n; --degree) {
    const double *share = fractions.value[degree + 1], *rest = fractions.rest[degree + 1];
    for (int k = 0; k <= degree; ++k)
      bar[k] = scaled(rest[k], bar[k]) + scaled(share[k + 1], bar[k + 1]);
  }
}

/// product_row (P + Q + 1 points) = factor (scalar, degree P) times row (degree Q).
template <int P, int Q, class Real>
void multiply(const Real* factor, const Vec3<Real>* row, Vec3<Real>* product_row) {
  unrolled<0, P + Q>([&](auto k) {
    constexpr int first = k > Q ? k - Q : 0, last = k < P ? k : P;
    const auto term = [&](auto i) {
      return (Real(product<P, Q>.weight[i][k - i]) * factor[i]) * row[k - i];
    };
    Vec3<Real> sum = term(Index<first>{});
    unrolled<first + 1, last>([&](auto i) { sum += term(i); });
    product_row[k] = sum;
  });
}

/// Pullback of multiply: adds to the adjoints of both factors.
template <int P, int Q, class Real>
void multiply_pullback(const Real* factor, const Vec3<Real>* row, const Vec3<Real>* product_bar,
                       Real* factor_bar, Vec3<Real>* row_bar) {
  unrolled<0, P>([&](auto i) {
    unrolled<0, Q>([&](auto j) {
      const Vec3<Real> weighted = scaled(product<P, Q>.weight[i][j], product_bar[i + j]);
      factor_bar[i] += dot(row[j], weighted);
      row_bar[j] += factor[i] * weighted;
    });
  });
}

/// product_row (q + 2 points) = factor (scalar, linear) times row (degree q), q <=
/// max_net_degree.
template <class Real>
void multiply_linear(int q, const Real* factor, const Vec3<Real>* row, Vec3<Real>* product_row) {
  const double *share = fractions.value[q + 1], *rest = fractions.rest[q + 1];
  product_row[0] = factor[0] * row[0];
  for (int k = 1; k <= q; ++k) {
    product_row[k] =
        (Real(rest[k]) * factor[0]) * row[k] + (Real(share[k]) * factor[1]) * row[k - 1];
  }
  product_row[q + 1] = factor[1] * row[q];
}

/// Pullback of multiply_linear: adds to the adjoints of both factors.
template <class Real>
void multiply_linear_pullback(int q, const Real* factor, const Vec3<Real>* row,
                              const Vec3<Real>* product_bar, Real* factor_bar,
                              Vec3<Real>* row_bar) {
  const double *share = fractions.value[q + 1], *rest = fractions.rest[q + 1];
  for (int j = 0; j <= q; ++j) {
    const Real weight0(rest[j]), weight1(share[j + 1]);
    factor_bar[0] += weight0 * dot(row[j], product_bar[j]);
    factor_bar[1] += weight1 * dot(row[j], product_bar[j + 1]);
    row_bar[j] +=
        (weight0 * factor[0]) * product_bar[j] + (weight1 * factor[1]) * product_bar[j + 1];
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
