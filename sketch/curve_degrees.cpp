#include "sketch/curve_degrees.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <stdexcept>

#include "model/elevation.hpp"
#include "model/family.hpp"
#include "model/suggest.hpp"
#include "sketch/curve_jet.hpp"
#include "sketch/gather_strokes.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr int least_degree = 2;

int degree_of(const model::Curve& curve) { return int(curve.points.size()) - 1; }

Points raised(const Points& points) {
  const int count = int(points.size());
  Points result{points.front()};
  for (int k = 1; k < count; ++k) {
    const double share = double(k) / count;
    result.push_back(share * points[k - 1] + (1.0 - share) * points[k]);
  }
  result.push_back(points.back());
  return result;
}

Points lowered(const Points& points, int degree) {
  const int count = 8 * int(points.size()), inner = degree - 1;
  Eigen::MatrixXd basis(count, inner), wanted(count, 3);
  for (int k = 0; k < count; ++k) {
    const double t = (k + 0.5) / count;
    const auto functions = model::bernstein(degree, t).d[0];
    for (int i = 0; i < inner; ++i) basis(k, i) = functions[i + 1];
    wanted.row(k) = curve_jet<3>(points, t).point - functions[0] * points.front() -
                    functions[degree] * points.back();
  }
  const Eigen::MatrixXd found = basis.colPivHouseholderQr().solve(wanted);
  Points result{points.front()};
  for (int i = 0; i < inner; ++i) result.emplace_back(found.row(i));
  result.push_back(points.back());
  return result;
}

// Exactly its own mirror image again, whatever was rounded.
void make_central(Points& points) {
  const std::size_t count = points.size();
  for (std::size_t k = 0; k < count / 2; ++k)
    points[count - 1 - k] = {points[k].x(), -points[k].y(), points[k].z()};
  if (count % 2 == 1) points[count / 2].y() = 0.0;
}

void check_degree(int degree) {
  if (degree >= least_degree && degree <= model::max_patch_degree) return;
  throw std::invalid_argument(
      "the degree of a curve is a whole number from " + std::to_string(least_degree) + " to " +
      std::to_string(model::max_patch_degree) + ", not " + std::to_string(degree));
}

int curve_named(const model::Model& model, const std::string& name) {
  std::vector<std::string> names;
  for (const model::Curve& curve : model.curves) names.push_back(curve.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return int(found - names.begin());
  throw std::invalid_argument("no curve is named '" + name + "'; the nearest name is '" +
                              model::nearest_name(name, names) + "'");
}

// Gives a curve a degree, and then those opposite to it.
void spread(const model::Model& model, int curve, int degree, int named,
            std::vector<std::optional<int>>& degrees, std::vector<int>& sources) {
  if (degrees[curve] && *degrees[curve] != degree)
    throw std::invalid_argument(
        "the curves '" + model.curves[sources[curve]].name + "' and '" + model.curves[named].name +
        "' lie on opposite sides of patches, so they need one degree, not " +
        std::to_string(*degrees[curve]) + " and " + std::to_string(degree));
  if (degrees[curve]) return;
  degrees[curve] = degree;
  sources[curve] = named;
  for (const model::Patch& patch : model.patches) {
    for (const int side : {0, 1, 2, 3}) {
      if (patch.sides[side].curve != curve) continue;
      spread(model, patch.sides[side ^ 1].curve, degree, named, degrees, sources);
    }
  }
}

std::vector<double> neutral_shapes(const model::AnyBasis& basis, int count) {
  std::vector<double> shapes;
  for (int k = 0; k < count; ++k) shapes.push_back(basis.neutral_shape(k % basis.shape_count()));
  return shapes;
}

void fit_shapes(const model::Model& model, model::Patch& patch) {
  const int u = degree_of(model.curves[patch.sides[std::size_t(model::Side::v0)].curve]);
  const int v = degree_of(model.curves[patch.sides[std::size_t(model::Side::u0)].curve]);
  const model::ShapeCounts counts = model::shape_counts(patch.basis, u, v);
  if (int(patch.shape_u.size()) != counts.u)
    patch.shape_u = neutral_shapes(*model::family(patch.basis, u), counts.u);
  if (int(patch.shape_v.size()) != counts.v)
    patch.shape_v = neutral_shapes(*model::family(patch.basis, v), counts.v);
}

}  // namespace

Points in_degree(Points points, int degree) {
  while (int(points.size()) - 1 < degree) points = raised(points);
  return int(points.size()) - 1 > degree ? lowered(points, degree) : points;
}

model::Model with_degrees(model::Model model, const CurveDegrees& degrees) {
  std::vector<std::optional<int>> wanted(model.curves.size());
  std::vector<int> sources(model.curves.size(), -1);
  if (degrees.all) check_degree(*degrees.all);
  for (const auto& [name, degree] : degrees.by_name) {
    check_degree(degree);
    const int curve = curve_named(model, name);
    spread(model, curve, degree, curve, wanted, sources);
  }
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    model::Curve& curve = model.curves[c];
    const bool central = is_central(curve);
    const std::optional<int> degree = wanted[c] ? wanted[c] : degrees.all;
    if (!degree || *degree == degree_of(curve)) continue;
    curve.points = in_degree(curve.points, *degree);
    if (central) make_central(curve.points);
  }
  for (model::Patch& patch : model.patches) fit_shapes(model, patch);
  return model;
}

}  // namespace bodyline::sketch
