#include "model/bezier_form.hpp"

#include "model/family.hpp"

namespace bodyline::model {
namespace {

using Eigen::MatrixXd;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // one to a row

// Control points of row i.
Points row_points(const FamilyPatch& patch, int i) {
  Points points(patch.degree_v + 1, 3);
  for (int j = 0; j <= patch.degree_v; ++j) points.row(j) = patch.point(i, j).transpose();
  return points;
}

// Bezier points of row i along v.
Points row_form(const FamilyPatch& patch, const AnyBasis& basis_v, int i) {
  return basis_v.conversion(row_shape(patch, i)).transpose() * row_points(patch, i);
}

}  // namespace

FamilyPatchBar::FamilyPatchBar(const FamilyPatch& patch)
    : points(patch.points.size(), Eigen::Vector3d::Zero()),
      shape_u(patch.shape_u.size(), 0.0),
      shape_v(patch.shape_v.size(), 0.0) {}

Surface bezier_form(const FamilyPatch& patch) {
  check_patch(patch);
  const auto basis_u = family(patch.family, patch.degree_u);
  const auto basis_v = family(patch.family, patch.degree_v);
  const FormMatrix in_u = basis_u->conversion(patch.shape_u);
  Surface surface;
  surface.name = patch.name;
  surface.degree_u = basis_u->bezier_degree();
  surface.degree_v = basis_v->bezier_degree();
  surface.net.assign((surface.degree_u + 1) * (surface.degree_v + 1), Eigen::Vector3d::Zero());
  for (int i = 0; i <= patch.degree_u; ++i) {
    const Points row = row_form(patch, *basis_v, i);
    for (int k = 0; k <= surface.degree_u; ++k) {
      if (in_u(i, k) == 0.0) continue;
      for (int l = 0; l <= surface.degree_v; ++l)
        surface.point(k, l) += in_u(i, k) * row.row(l).transpose();
    }
  }
  return surface;
}

void bezier_form_pullback(const FamilyPatch& patch, const std::vector<Eigen::Vector3d>& net_bar,
                          FamilyPatchBar& bar) {
  const auto basis_u = family(patch.family, patch.degree_u);
  const auto basis_v = family(patch.family, patch.degree_v);
  const FormMatrix in_u = basis_u->conversion(patch.shape_u);
  const int rows = basis_u->bezier_degree() + 1, columns = basis_v->bezier_degree() + 1;
  MatrixXd in_u_bar = MatrixXd::Zero(in_u.rows(), in_u.cols());
  for (int i = 0; i <= patch.degree_u; ++i) {
    const Points row = row_form(patch, *basis_v, i);
    Points row_bar = Points::Zero(columns, 3);
    for (int k = 0; k < rows; ++k) {
      for (int l = 0; l < columns; ++l) {
        const Eigen::Vector3d& at = net_bar[k * columns + l];
        row_bar.row(l) += in_u(i, k) * at.transpose();
        in_u_bar(i, k) += row.row(l).dot(at.transpose());
      }
    }
    const std::span<const double> shape = row_shape(patch, i);
    const Points points_bar = basis_v->conversion(shape) * row_bar;
    for (int j = 0; j <= patch.degree_v; ++j)
      bar.points[i * (patch.degree_v + 1) + j] += points_bar.row(j).transpose();
    const MatrixXd in_v_bar = row_points(patch, i) * row_bar.transpose();
    for (int k = 0; k < int(shape.size()); ++k) {
      bar.shape_v[shape_row(patch, i).first + k] +=
          basis_v->conversion_derivative(shape, k).cwiseProduct(in_v_bar).sum();
    }
  }
  for (int k = 0; k < int(patch.shape_u.size()); ++k) {
    bar.shape_u[k] += basis_u->conversion_derivative(patch.shape_u, k).cwiseProduct(in_u_bar).sum();
  }
}

}  // namespace bodyline::model
