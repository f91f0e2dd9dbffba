#include "model/connect_shapes.hpp"

#include <cmath>

#include "model/family.hpp"
#include "model/number_text.hpp"

namespace bodyline::model {
namespace {

// Shape parameters along u or along v.
struct Direction {
  const char* name;
  const std::vector<double>* shape;
  int degree;
};

void check_degree(const Patch& patch, const Family& of, const Direction& direction) {
  if (direction.degree >= of.min_degree && direction.degree <= of.max_degree) return;
  throw ModelError("patches." + patch.name + ".basis",
                   "is \"" + of.name + "\", which needs degrees from " +
                       std::to_string(of.min_degree) + " to " + std::to_string(of.max_degree) +
                       ", but the patch is of degree " + std::to_string(direction.degree) +
                       " along " + direction.name);
}

void check_range(const Family& of, const AnyBasis& basis, const std::vector<double>& shape,
                 const std::string& key) {
  for (int k = 0; k < int(shape.size()); ++k) {
    if (!std::isfinite(shape[k]))
      throw ModelError(key, "is " + number_text(shape[k]) + "; a finite number is needed");
    const ShapeRange range = basis.body_range(k % basis.shape_count());
    if (shape[k] >= range.lower && shape[k] <= range.upper) continue;
    throw ModelError(key + "[" + std::to_string(k) + "]",
                     "is " + number_text(shape[k]) + "; in a patch of the family " + of.name +
                         " it must be from " + number_text(range.lower) + " to " +
                         number_text(range.upper));
  }
}

void check_count(const Family& of, const Direction& direction, int count, const std::string& key) {
  const int given = int(direction.shape->size());
  if (given == count) return;
  throw ModelError(key, "has " + std::to_string(given) + " values; a " + of.name +
                            " patch of degree " + std::to_string(direction.degree) +
                            " in this direction has " + std::to_string(count));
}

void check_symmetry(const AnyBasis& basis, const std::vector<double>& shape,
                    const std::string& key) {
  for (int k = 0; k < int(shape.size()); ++k) {
    const int image = mirrored_shape(basis, k);
    if (shape[k] == shape[image]) continue;
    throw ModelError(key, "is not symmetric, as on a central patch it must be: value " +
                              std::to_string(k) + " is " + number_text(shape[k]) + ", value " +
                              std::to_string(image) + " is " + number_text(shape[image]));
  }
}

}  // namespace

void check_shapes(const Model& model, const Patch& patch) {
  const Direction u{"u", &patch.shape_u, side_degree(model, patch, Side::v0)};
  const Direction v{"v", &patch.shape_v, side_degree(model, patch, Side::u0)};
  // Opposite sides of different degree are refused later, and with the better sentence.
  if (side_degree(model, patch, Side::v1) != u.degree ||
      side_degree(model, patch, Side::u1) != v.degree)
    return;
  const std::string key = "patches." + patch.name;
  const Family* of = nullptr;
  try {
    of = &find_family(patch.basis);
  } catch (const std::invalid_argument& error) {
    throw ModelError(key + ".basis", error.what());
  }
  check_degree(patch, *of, u);
  check_degree(patch, *of, v);
  const auto basis_u = family(patch.basis, u.degree), basis_v = family(patch.basis, v.degree);
  const ShapeCounts counts = shape_counts(patch.basis, u.degree, v.degree);
  check_count(*of, u, counts.u, key + ".shape.u");
  check_count(*of, v, counts.v, key + ".shape.v");
  check_range(*of, *basis_u, patch.shape_u, key + ".shape.u");
  check_range(*of, *basis_v, patch.shape_v, key + ".shape.v");
  if (patch.central) check_symmetry(*basis_v, patch.shape_v, key + ".shape.v");
}

}  // namespace bodyline::model
