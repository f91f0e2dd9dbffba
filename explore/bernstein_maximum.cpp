#include "explore/bernstein_maximum.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

constexpr double tolerance = 1e-7;
constexpr int deepest = 60;  // halvings; a parameter has no more bits

int count(const BernsteinPatch& p) { return (p.degree_u + 1) * (p.degree_v + 1); }

// 1 where the coefficients never fall along u or v, -1 where they never rise, 0 otherwise.
int trend(const BernsteinPatch& p, int stride, int total_steps) {
  bool rises = false, falls = false;
  for (int k = 0; k < total_steps; ++k) {
    const double step = p.c[k + stride] - p.c[k];
    rises |= step > 0.0;
    falls |= step < 0.0;
  }
  return falls ? (rises ? 0 : -1) : 1;
}

int trend_u(const BernsteinPatch& p) {
  const int row = p.degree_v + 1;
  return trend(p, row, p.degree_u * row);
}

int trend_v(const BernsteinPatch& p) {
  bool rises = false, falls = false;
  for (int i = 0; i <= p.degree_u; ++i) {
    const double* const row = p.c + i * (p.degree_v + 1);
    for (int j = 0; j < p.degree_v; ++j) {
      rises |= row[j + 1] > row[j];
      falls |= row[j + 1] < row[j];
    }
  }
  return falls ? (rises ? 0 : -1) : 1;
}

// The edge u = 0 or u = 1 in place of the patch.
void keep_edge_u(BernsteinPatch& p, bool end) {
  if (end) std::copy_n(p.c + p.degree_u * (p.degree_v + 1), p.degree_v + 1, p.c);
  p.degree_u = 0;
}

void keep_edge_v(BernsteinPatch& p, bool end) {
  for (int i = 0; i <= p.degree_u; ++i) p.c[i] = p.c[i * (p.degree_v + 1) + (end ? p.degree_v : 0)];
  p.degree_v = 0;
}

// De Casteljau at one half along u: `p` keeps the first half.
void split_u(BernsteinPatch& p, BernsteinPatch& second) {
  const int row = p.degree_v + 1, n = p.degree_u;
  second.degree_u = n;
  second.degree_v = p.degree_v;
  for (int level = 0; level <= n; ++level) {
    std::copy_n(p.c + n * row, row, second.c + (n - level) * row);
    for (int k = (n + 1) * row - 1; k >= (level + 1) * row; --k)
      p.c[k] = 0.5 * (p.c[k] + p.c[k - row]);
  }
}

void split_v(BernsteinPatch& p, BernsteinPatch& second) {
  const int row = p.degree_v + 1, n = p.degree_v;
  second.degree_u = p.degree_u;
  second.degree_v = n;
  for (int i = 0; i <= p.degree_u; ++i) {
    double* const a = p.c + i * row;
    double* const b = second.c + i * row;
    for (int level = 0; level <= n; ++level) {
      b[n - level] = a[n];
      for (int j = n; j > level; --j) a[j] = 0.5 * (a[j] + a[j - 1]);
    }
  }
}

double largest_corner(const BernsteinPatch& p) {
  const int last = count(p) - 1;
  return std::max(std::max(p.c[0], p.c[p.degree_v]), std::max(p.c[last - p.degree_v], p.c[last]));
}

// How much the coefficients differ along u, and along v.
bool varies_more_along_u(const BernsteinPatch& p) {
  if (p.degree_u == 0 || p.degree_v == 0) return p.degree_v == 0;
  double along_u = 0.0, along_v = 0.0;
  const int row = p.degree_v + 1;
  for (int k = 0; k < p.degree_u * row; ++k)
    along_u = std::max(along_u, std::abs(p.c[k + row] - p.c[k]));
  for (int k = 0; k + 1 < count(p); ++k) {
    if (k % row != p.degree_v) along_v = std::max(along_v, std::abs(p.c[k + 1] - p.c[k]));
  }
  return along_u > along_v;
}

void raise(BernsteinPatch& p, int depth, double& best) {
  best = std::max(best, largest_corner(p));
  if (*std::max_element(p.c, p.c + count(p)) <= best + tolerance || depth == deepest) return;
  if (p.degree_u > 0) {
    if (const int trend = trend_u(p); trend != 0) keep_edge_u(p, trend > 0);
  }
  if (p.degree_v > 0) {
    if (const int trend = trend_v(p); trend != 0) keep_edge_v(p, trend > 0);
  }
  if (p.degree_u == 0 && p.degree_v == 0) return;  // a corner
  BernsteinPatch second;
  if (varies_more_along_u(p)) {
    split_u(p, second);
  } else {
    split_v(p, second);
  }
  raise(second, depth + 1, best);
  raise(p, depth + 1, best);
}

}  // namespace

double maximum(const BernsteinPatch& patch, double best) {
  BernsteinPatch work = patch;
  raise(work, 0, best);
  return best;
}

}  // namespace bodyline::explore
