#include "model/shaped_patch.hpp"

namespace bodyline::model {
namespace {

// From Bezier points of one degree to those of a higher one.
FormMatrix raise_matrix(int from, int to) {
  FormMatrix matrix = FormMatrix::Zero(to + 1, from + 1);
  for (int k = 0; k <= to; ++k) {
    for (int i = 0; i <= from; ++i)
      matrix(k, i) = binomial(from, i) * binomial(to - from, k - i) / binomial(to, k);
  }
  return matrix;
}

}  // namespace

ShapedPatch::ShapedPatch(const std::string& name, int m_, int n_, int net_m_, int net_n_)
    : m(m_),
      n(n_),
      net_m(net_m_),
      net_n(net_n_),
      shape_per_row(find_family(name).shape_per_row),
      basis_u(family(name, m)),
      basis_v(family(name, n)),
      raise_u(raise_matrix(m, net_m)),
      raise_v(raise_matrix(n, net_n)),
      raise_abscissa_u(raise_matrix(basis_u->abscissa_degree(), net_m)),
      raise_abscissa_v(raise_matrix(basis_v->abscissa_degree(), net_n)) {
  if (shape_per_row) raise_row = raise_matrix(basis_v->bezier_degree(), net_n);
}

}  // namespace bodyline::model
