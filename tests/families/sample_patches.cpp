#include "sample_patches.hpp"

#include "model/family.hpp"

namespace bodyline::testing {
namespace {

constexpr double side_mm = 300.0, bump_mm = 40.0;

double between(double low, double high, std::mt19937& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Vector3d bump(std::mt19937& random) {
  return {between(-0.2, 0.2, random) * bump_mm, between(-0.2, 0.2, random) * bump_mm,
          between(-1.0, 1.0, random) * bump_mm};
}

double& shape_at(model::FamilyPatch& first, model::FamilyPatch& second,
                 const model::ShapePlace& place) {
  model::FamilyPatch& patch = place.patch == 0 ? first : second;
  return (place.in_v ? patch.shape_v : patch.shape_u)[place.index];
}

}  // namespace

std::vector<double> random_shape(const std::string& family, int degree, int sets,
                                 std::mt19937& random) {
  const auto basis = model::family(family, degree);
  std::vector<double> shape;
  for (int set = 0; set < sets; ++set) {
    for (int k = 0; k < basis->shape_count(); ++k) {
      const model::ShapeRange range = basis->shape_range(k);
      shape.push_back(between(range.lower, std::min(range.upper, 6.0), random));
    }
  }
  return shape;
}

model::FamilyPatch random_patch(const std::string& family, int degree_u, int degree_v,
                                const Eigen::Vector3d& origin, std::mt19937& random) {
  model::FamilyPatch patch;
  patch.name = "patch";
  patch.family = family;
  patch.degree_u = degree_u;
  patch.degree_v = degree_v;
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j) {
      patch.points.push_back(origin +
                             Eigen::Vector3d(side_mm * i / degree_u, side_mm * j / degree_v, 0.0) +
                             bump(random));
    }
  }
  patch.shape_u = random_shape(family, degree_u, 1, random);
  const int sets = model::find_family(family).shape_per_row ? degree_u + 1 : 1;
  patch.shape_v = random_shape(family, degree_v, sets, random);
  return patch;
}

model::FamilyCurve random_curve(const std::string& family, int degree, std::mt19937& random) {
  model::FamilyCurve curve;
  curve.name = "curve";
  curve.family = family;
  for (int i = 0; i <= degree; ++i)
    curve.points.push_back(Eigen::Vector3d(side_mm * i / degree, 0.0, 0.0) + bump(random));
  curve.shape = random_shape(family, degree, 1, random);
  return curve;
}

void share_shapes(model::FamilyPatch& first, const model::PatchJoin& join,
                  model::FamilyPatch& second) {
  for (const model::ShapeTie& tie : model::join_ties(first, join, second))
    shape_at(first, second, tie.b) = shape_at(first, second, tie.a);
}

model::PatchChain random_chain(const std::string& family, int continuity, std::mt19937& random) {
  using model::JoinDirection;
  model::PatchChain chain;
  chain.name = "chain";
  chain.joins = {{JoinDirection::u, continuity, 0.9, 0.2},
                 {JoinDirection::uv, continuity, 1.1, -0.1},
                 {JoinDirection::v, continuity, 1.0, 0.0}};
  const char* const names[] = {"one", "two", "three", "four"};
  for (int k = 0; k < 4; ++k) {
    // The third patch and the fourth run across what the first two run along; where their rows are
    // tied at both ends, there are some more between.
    const int degree_u = k >= 2 && model::find_family(family).shape_per_row ? 6 : 3;
    chain.patches.push_back(random_patch(family, degree_u, 3, {0.0, side_mm * k, 0.0}, random));
    chain.patches.back().name = names[k];
    if (k < 2) continue;
    for (Eigen::Vector3d& point : chain.patches.back().points)
      point = {point.y() - side_mm * k, point.x() + side_mm * k, point.z()};
  }
  for (int k = 0; k < 3; ++k) share_shapes(chain.patches[k], chain.joins[k], chain.patches[k + 1]);
  model::propagate(chain);
  return chain;
}

}  // namespace bodyline::testing
