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

// Value and first two derivatives of the polynomial c[0..n] at t, n >= 2, by de Casteljau.
struct CurveJet {
  double d[3];
};
CurveJet curve_jet(const double* c, int n, double t) {
  double b[model::max_degree + 1];
  std::copy_n(c, n + 1, b);
  for (int level = n; level > 2; --level) {
    for (int k = 0; k < level; ++k) b[k] += t * (b[k + 1] - b[k]);
  }
  const double first = b[1] - b[0], second = b[2] - b[1];
  const double p0 = b[0] + t * first, p1 = b[1] + t * second;
  return {{p0 + t * (p1 - p0), n * (p1 - p0), n * (n - 1) * (second - first)}};
}

// Whether c[0..n] is concave and highest between its ends.
bool is_arch(const double* c, int n) {
  if (n < 2 || !(c[1] > c[0]) || !(c[n] < c[n - 1])) return false;
  for (int k = 2; k <= n; ++k) {
    if (c[k] - c[k - 1] > c[k - 1] - c[k - 2]) return false;
  }
  return true;
}

// The top of an arch, by Newton's method within a bracket. A concave function lies below its
// tangents: they say when the top is found, or that it is not the best.
void climb_arch(const double* c, int n, double& best) {
  double low = 0.0, high = 1.0;
  double t = (c[1] - c[0]) / ((c[1] - c[0]) + (c[n - 1] - c[n]));
  for (int step = 0; step < deepest; ++step) {
    const CurveJet f = curve_jet(c, n, t);
    (f.d[1] > 0.0 ? low : high) = t;
    const double rest = f.d[1] > 0.0 ? f.d[1] * (high - t) : f.d[1] * (low - t);
    best = std::max(best, f.d[0]);
    if (f.d[0] + rest <= best + tolerance) return;
    t -= f.d[1] / f.d[2];
    if (!(t > low && t < high)) t = 0.5 * (low + high);
  }
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
  // Along an edge the coefficients lie side by side.
  if (const int n = p.degree_u + p.degree_v; count(p) == n + 1 && is_arch(p.c, n))
    return climb_arch(p.c, n, best);
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
  BernsteinPatch work;  // the room behind the coefficients is not worth a copy
  work.degree_u = patch.degree_u;
  work.degree_v = patch.degree_v;
  std::copy_n(patch.c, count(patch), work.c);
  raise(work, 0, best);
  return best;
}

}  // namespace bodyline::explore
