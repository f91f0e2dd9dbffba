#include "model/bezier_pieces.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "model/number_text.hpp"

namespace bodyline::model {
namespace {

constexpr int span_degree = 5;  // two derivatives at both ends
constexpr int samples = 7;      // of the error of a span
constexpr int most_halvings = 60;

// Bezier points of degree 5 with the jets of function i at both ends, h apart.
Eigen::Matrix<double, 1, 6> hermite_points(const BasisJet& from, const BasisJet& to, int i,
                                           double h) {
  Eigen::Matrix<double, 1, 6> c;
  c[0] = from.d[0][i];
  c[1] = c[0] + h * from.d[1][i] / 5.0;
  c[2] = 2.0 * c[1] - c[0] + h * h * from.d[2][i] / 20.0;
  c[5] = to.d[0][i];
  c[4] = c[5] - h * to.d[1][i] / 5.0;
  c[3] = 2.0 * c[4] - c[5] + h * h * to.d[2][i] / 20.0;
  return c;
}

// Bezier forms of all functions between two parameters.
FormMatrix bezier_span(const AnyBasis& basis, std::span<const double> shape, double from,
                       double to) {
  const BasisJet low = basis.evaluate(from, shape), high = basis.evaluate(to, shape);
  FormMatrix form(basis.degree() + 1, span_degree + 1);
  for (int i = 0; i <= basis.degree(); ++i) form.row(i) = hermite_points(low, high, i, to - from);
  return form;
}

double span_error(const AnyBasis& basis, std::span<const double> shape, double from, double to) {
  const FormMatrix form = bezier_span(basis, shape, from, to);
  double worst = 0.0;
  for (int k = 1; k <= samples; ++k) {
    const double share = double(k) / (samples + 1);
    const BasisJet exact = basis.evaluate(from + share * (to - from), shape);
    const BernsteinJet bernstein_jet = bernstein(span_degree, share);
    double sum = 0.0;
    for (int i = 0; i <= basis.degree(); ++i) {
      double value = 0.0;
      for (int l = 0; l <= span_degree; ++l) value += form(i, l) * bernstein_jet.d[0][l];
      sum += std::abs(value - exact.d[0][i]);
    }
    worst = std::max(worst, sum);
  }
  return worst;
}

void halve(const AnyBasis& basis, std::span<const double> shape, double from, double to,
           double tolerance, int halvings, std::vector<double>& breaks) {
  // The error of an interpolant is largest near the middle; a factor two is for what lies between
  // the samples.
  if (halvings == 0 || 2.0 * span_error(basis, shape, from, to) <= tolerance) {
    breaks.push_back(to);
    return;
  }
  const double middle = 0.5 * (from + to);
  halve(basis, shape, from, middle, tolerance, halvings - 1, breaks);
  halve(basis, shape, middle, to, tolerance, halvings - 1, breaks);
}

// The piece over span a of u and span b of v; forms_v[i][b] is that of row i.
Surface piece(const FamilyPatch& patch, const FormMatrix& form_u,
              const std::vector<std::vector<FormMatrix>>& forms_v, std::size_t b) {
  Surface surface;
  surface.degree_u = int(form_u.cols()) - 1;
  surface.degree_v = int(forms_v[0][b].cols()) - 1;
  surface.net.assign((surface.degree_u + 1) * (surface.degree_v + 1), Eigen::Vector3d::Zero());
  for (int i = 0; i <= patch.degree_u; ++i) {
    for (int l = 0; l <= surface.degree_v; ++l) {
      Eigen::Vector3d row = Eigen::Vector3d::Zero();
      for (int j = 0; j <= patch.degree_v; ++j) row += forms_v[i][b](j, l) * patch.point(i, j);
      for (int k = 0; k <= surface.degree_u; ++k) surface.point(k, l) += form_u(i, k) * row;
    }
  }
  return surface;
}

}  // namespace

std::vector<double> bezier_breaks(const AnyBasis& basis, std::span<const double> shape,
                                  double tolerance) {
  if (!(tolerance > 0.0)) {
    throw std::invalid_argument("a tolerance is " + number_text(tolerance) +
                                "; it must be positive");
  }
  std::vector<double> breaks{0.0};
  halve(basis, shape, 0.0, 1.0, tolerance, most_halvings, breaks);
  return breaks;
}

std::vector<FormMatrix> bezier_spans(const Family& family, const AnyBasis& basis,
                                     std::span<const double> shape, double tolerance) {
  if (family.polynomial) return {basis.conversion(shape)};
  const std::vector<double> breaks = bezier_breaks(basis, shape, tolerance);
  std::vector<FormMatrix> forms;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    forms.push_back(bezier_span(basis, shape, breaks[k], breaks[k + 1]));
  return forms;
}

std::vector<Surface> bezier_pieces(const FamilyPatch& patch, double tolerance_mm, double size_mm) {
  check_patch(patch);
  if (!(tolerance_mm > 0.0 && size_mm > 0.0))
    throw std::invalid_argument("a tolerance and a size must be positive lengths");
  // Half the tolerance for either direction; the errors of all functions sum to zero, so that only
  // distances between control points count.
  const double tolerance = 0.5 * tolerance_mm / size_mm;
  const auto basis_u = family(patch.family, patch.degree_u);
  const auto basis_v = family(patch.family, patch.degree_v);
  const Family& patch_family = find_family(patch.family);
  const std::vector<FormMatrix> forms_u =
      bezier_spans(patch_family, *basis_u, patch.shape_u, tolerance);
  std::vector<std::vector<FormMatrix>> forms_v;
  for (int i = 0; i <= patch.degree_u; ++i)
    forms_v.push_back(bezier_spans(patch_family, *basis_v, row_shape(patch, i), tolerance));
  std::vector<Surface> pieces;
  for (const FormMatrix& form_u : forms_u) {
    for (std::size_t b = 0; b < forms_v[0].size(); ++b)
      pieces.push_back(piece(patch, form_u, forms_v, b));
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    pieces[k].name = pieces.size() == 1 ? patch.name : patch.name + "." + std::to_string(k + 1);
  }
  return pieces;
}

double control_size(const std::vector<Eigen::Vector3d>& points) {
  if (points.empty()) return 0.0;
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return std::sqrt(3.0) * (high - low).maxCoeff();
}

}  // namespace bodyline::model
