#include "model/family_patch.hpp"

#include <stdexcept>

#include "model/family.hpp"
#include "model/number_text.hpp"

namespace bodyline::model {
namespace {

[[noreturn]] void fail(const FamilyPatch& patch, const std::string& sentence) {
  throw std::invalid_argument("patch \"" + patch.name + "\" " + sentence);
}

void check_shape(const FamilyPatch& patch, const AnyBasis& basis, const std::vector<double>& shape,
                 int count, const std::string& direction) {
  if (int(shape.size()) != count) {
    fail(patch, "has " + std::to_string(shape.size()) + " shape parameters along " + direction +
                    ", but needs " + std::to_string(count));
  }
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const ShapeRange range = basis.shape_range(int(k) % basis.shape_count());
    if (shape[k] >= range.lower && shape[k] <= range.upper) continue;
    fail(patch, "has a shape parameter along " + direction + " of " + number_text(shape[k]) +
                    "; it must be from " + number_text(range.lower) + " to " +
                    number_text(range.upper));
  }
}

}  // namespace

void check_patch(const FamilyPatch& patch) {
  const auto basis_u = family(patch.family, patch.degree_u);
  const auto basis_v = family(patch.family, patch.degree_v);
  const int points = (patch.degree_u + 1) * (patch.degree_v + 1);
  if (int(patch.points.size()) != points) {
    fail(patch, "has " + std::to_string(patch.points.size()) + " control points, but needs " +
                    std::to_string(points));
  }
  for (const Eigen::Vector3d& point : patch.points) {
    if (!point.allFinite()) fail(patch, "has a control point that is not finite");
  }
  const ShapeCounts counts = shape_counts(patch.family, patch.degree_u, patch.degree_v);
  check_shape(patch, *basis_u, patch.shape_u, counts.u, "u");
  check_shape(patch, *basis_v, patch.shape_v, counts.v, "v");
}

ShapeRow shape_row(const FamilyPatch& patch, int i) {
  if (!find_family(patch.family).shape_per_row) return {0, int(patch.shape_v.size())};
  const int count = int(patch.shape_v.size()) / (patch.degree_u + 1);
  return {i * count, count};
}

std::span<const double> row_shape(const FamilyPatch& patch, int i) {
  const ShapeRow row = shape_row(patch, i);
  return std::span(patch.shape_v).subspan(row.first, row.count);
}

SurfaceJet jet(const FamilyPatch& patch, double u, double v) {
  const auto basis_u = family(patch.family, patch.degree_u);
  const auto basis_v = family(patch.family, patch.degree_v);
  const BasisJet along_u = basis_u->evaluate(u, patch.shape_u);
  SurfaceJet result;
  for (Eigen::Vector3d& d : result.d) d.setZero();
  for (int i = 0; i <= patch.degree_u; ++i) {
    const BasisJet along_v = basis_v->evaluate(v, row_shape(patch, i));
    for (int b = 0; b <= 3; ++b) {
      Eigen::Vector3d row = Eigen::Vector3d::Zero();
      for (int j = 0; j <= patch.degree_v; ++j) row += along_v.d[b][j] * patch.point(i, j);
      for (int a = 0; a + b <= 3; ++a) result.d[jet_index(a, b)] += along_u.d[a][i] * row;
    }
  }
  return result;
}

}  // namespace bodyline::model
