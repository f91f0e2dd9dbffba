#pragma once

#include "model/kernel_foot_point.hpp"
#include "model/kernels.hpp"

/// Sums over points of products of Bernstein polynomials, from which the normal equations of a
/// least-squares fit of one face follow. See kernels_impl.cpp.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

constexpr int max_doubled = 2 * max_foot_degree + 1;      // polynomials of a doubled degree
constexpr int max_width = moment_width(max_foot_degree);  // of a row for one entry
constexpr int moment_group = 32;                          // points whose bases are held at a time

/// Bernstein polynomials at a group of points.
struct GroupBasis {
  double along_u[max_doubled][moment_group];  // of the doubled degree, point by point
  double along_v[moment_group][max_width];    // likewise, polynomial by polynomial
  Lanes single_u[max_foot_degree + 1], single_v[max_foot_degree + 1];  // of `lanes` points
};

/// Polynomials of a degree and of twice that degree.
BODYLINE_INLINE void doubled_bernstein(int degree, Lanes t, Lanes* single, Lanes* doubled) {
  const Lanes s = 1.0 - t;
  doubled[0] = broadcast(1.0);
  for (int k = 0; k < degree; ++k) raise_bernstein(k, t, s, doubled);
  for (int k = 0; k <= degree; ++k) single[k] = doubled[k];
  for (int k = degree; k < 2 * degree; ++k) raise_bernstein(k, t, s, doubled);
}

/// Adds the first moments of `lanes` points, lane by lane.
BODYLINE_INLINE void add_first(int degree_u, int degree_v, const GroupBasis& basis,
                               const Vector& target, Lanes* first) {
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j, first += 3) {
      const Lanes b = basis.single_u[i] * basis.single_v[j];
      first[0] += b * target.x;
      first[1] += b * target.y;
      first[2] += b * target.z;
    }
  }
}

/// Adds the second moments of a group of `count` points, for `entries` neighbouring entries of W
/// and `lanes` neighbouring polynomials in v; `rows` polynomials in u.
template <int entries>
BODYLINE_INLINE void add_second(int rows, int width, const GroupBasis& basis, int count,
                                const double* const* weight, double* second) {
  const int stride = 6 * width;
  for (int column = 0; column < width; column += lanes) {
    Lanes total[max_doubled][entries];
    for (int a = 0; a < rows; ++a)
      for (int e = 0; e < entries; ++e)
        total[a][e] = load(second + a * stride + e * width + column);
    for (int p = 0; p < count; ++p) {
      const Lanes b = load(basis.along_v[p] + column);
      Lanes product[entries];
      for (int e = 0; e < entries; ++e) product[e] = b * weight[e][p];
#pragma GCC unroll 7
      for (int a = 0; a < rows; ++a) {
        const Lanes factor = held(broadcast(basis.along_u[a][p]));
#pragma GCC unroll 3
        for (int e = 0; e < entries; ++e) total[a][e] += factor * product[e];
      }
    }
    for (int a = 0; a < rows; ++a)
      for (int e = 0; e < entries; ++e)
        store(second + a * stride + e * width + column, total[a][e]);
  }
}

BODYLINE_INLINE void add_moments_of_degree(int degree_u, int degree_v, const PullArrays& pulls,
                                           double* second, double* first) {
  constexpr int entries = lanes == 8 ? 3 : 1;  // as many sums as there are registers
  const int rows = 2 * degree_u + 1, columns = 2 * degree_v + 1, width = moment_width(degree_v);
  Lanes first_lanes[3 * (max_foot_degree + 1) * (max_foot_degree + 1)];
  const int size = 3 * (degree_u + 1) * (degree_v + 1);
  for (int k = 0; k < size; ++k) first_lanes[k] = Lanes{};
  GroupBasis basis;
  for (int p = 0; p < moment_group; ++p)
    for (int b = columns; b < width; ++b) basis.along_v[p][b] = 0.0;
  for (int begin = 0; begin < pulls.count; begin += moment_group) {
    const int left = pulls.count - begin, count = left < moment_group ? left : moment_group;
    for (int p = 0; p < count; p += lanes) {
      Lanes doubled[max_doubled];
      doubled_bernstein(degree_u, load(pulls.u + begin + p), basis.single_u, doubled);
      for (int a = 0; a < rows; ++a) store(basis.along_u[a] + p, doubled[a]);
      doubled_bernstein(degree_v, load(pulls.v + begin + p), basis.single_v, doubled);
      for (int b = 0; b < columns; ++b)
        for (int k = 0; k < lanes; ++k) basis.along_v[p + k][b] = doubled[b][k];
      const double* const* const t = pulls.weighted_target;
      add_first(degree_u, degree_v, basis,
                {load(t[0] + begin + p), load(t[1] + begin + p), load(t[2] + begin + p)},
                first_lanes);
    }
    for (int e = 0; e < 6; e += entries) {
      const double* weight[entries];
      for (int k = 0; k < entries; ++k) weight[k] = pulls.weight[e + k] + begin;
      add_second<entries>(rows, width, basis, count, weight, second + e * width);
    }
  }
  for (int k = 0; k < size; ++k) first[k] += sum(first_lanes[k]);
}

inline void add_moments(int degree_u, int degree_v, const PullArrays& pulls, double* second,
                        double* first) {
  // Known degrees let the compiler keep the sums in registers.
  if (degree_u == 3 && degree_v == 3)
    add_moments_of_degree(3, 3, pulls, second, first);
  else
    add_moments_of_degree(degree_u, degree_v, pulls, second, first);
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
