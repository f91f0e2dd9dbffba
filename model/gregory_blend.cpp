#include "model/gregory_blend.hpp"

#include "model/surface.hpp"

namespace bodyline::model {
namespace {

/// Bivariate Taylor series truncated after total degree 3; coefficient (a, b) stands at
/// jet_index(a, b).
struct Series {
  std::array<double, 10> c{};
  double& at(int a, int b) { return c[jet_index(a, b)]; }
  double at(int a, int b) const { return c[jet_index(a, b)]; }
};

template <class Visit>
void for_each_term(Visit visit) {
  for (int degree = 0; degree <= 3; ++degree)
    for (int b = 0; b <= degree; ++b) visit(degree - b, b);
}

/// The terms of x * y at (a, b), the one of x(0,0) with y(a,b) left out where `skip` says so.
double convolution(const Series& x, const Series& y, int a, int b, bool skip) {
  double sum = 0.0;
  for (int i = 0; i <= a; ++i)
    for (int j = 0; j <= b; ++j)
      if (!skip || i + j > 0) sum += x.at(i, j) * y.at(a - i, b - j);
  return sum;
}

Series operator*(const Series& x, const Series& y) {
  Series product;
  for_each_term([&](int a, int b) { product.at(a, b) = convolution(x, y, a, b, false); });
  return product;
}

Series operator/(const Series& x, const Series& y) {
  Series quotient;
  for_each_term([&](int a, int b) {
    quotient.at(a, b) = (x.at(a, b) - convolution(y, quotient, a, b, true)) / y.at(0, 0);
  });
  return quotient;
}

/// t (1-t)^2 around t, in the direction of u or v.
Series bump(double t, bool along_u) {
  const double s = 1.0 - t;
  const double taylor[4] = {t * s * s, s * (1.0 - 3.0 * t), 3.0 * t - 2.0, 1.0};
  Series series;
  for (int k = 0; k <= 3; ++k) series.at(along_u ? k : 0, along_u ? 0 : k) = taylor[k];
  return series;
}

/// u^2 + sign v^2 around (u, v).
Series squares(double u, double v, double sign) {
  Series series;
  series.at(0, 0) = sign > 0.0 ? u * u + v * v : (u - v) * (u + v);
  series.at(1, 0) = 2.0 * u;
  series.at(0, 1) = 2.0 * sign * v;
  series.at(2, 0) = 1.0;
  series.at(0, 2) = sign;
  return series;
}

}  // namespace

std::array<double, 10> blend_jet(double u, double v) {
  // Closer to the corner u^2 + v^2 would lose its digits to underflow.
  constexpr double corner_radius = 1e-100;
  if (u < corner_radius && v < corner_radius) return {};
  const Series g = bump(u, true) * bump(v, false) * (squares(u, v, -1.0) / squares(u, v, 1.0));
  constexpr double factorial[4] = {1.0, 1.0, 2.0, 6.0};
  std::array<double, 10> jet{};
  for_each_term(
      [&](int a, int b) { jet[jet_index(a, b)] = g.at(a, b) * factorial[a] * factorial[b]; });
  return jet;
}

}  // namespace bodyline::model
