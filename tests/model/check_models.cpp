#include "check_models.hpp"

#include <stdexcept>

#include "io/read_model.hpp"
#include "model/connect.hpp"
#include "model/family.hpp"
#include "model/selection.hpp"

namespace bodyline::testing {

model::Model load_car(const std::string& name) {
  return io::read_model(std::string(BODYLINE_SOURCE_DIR) + "/cars/" + name + ".toml");
}

model::Model perturbed_car(const std::string& name, std::mt19937& random) {
  model::Model car = load_car(name);
  const model::Connectivity links = model::connect(car);
  model::VariableBounds bounds;
  bounds.min_cut = 0.05;
  bounds.max_cut = 0.2;
  const model::VariableMap map(car, links, bounds);
  Eigen::VectorXd parameters = model::to_parameters(car, map.layout());
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int k = 0; k < map.count(); ++k) {
    const model::Variable& variable = map.variables()[k];
    const model::Selection one(map, {k});
    Eigen::VectorXd x = one.gather(parameters);
    switch (variable.kind) {
      case model::ParameterKind::curve:
        x[0] += between(-8.0, 8.0);
        break;
      case model::ParameterKind::shape:
        x[0] += between(-0.3, 0.3);
        break;
      case model::ParameterKind::cut:
        x[0] = between(variable.lower, variable.upper);
        break;
      case model::ParameterKind::fullness:
        x[0] = between(0.8, 2.2);
        break;
      case model::ParameterKind::lean:
        x[0] = between(0.3, 1.0);
        break;
    }
    one.scatter(x, parameters);
  }
  model::set_parameters(car, map.layout(), parameters);
  return car;
}

void set_family(model::Model& car, const std::string& name, const std::string& family,
                std::mt19937& random) {
  for (model::Patch& patch : car.patches) {
    if (patch.name != name) continue;
    const int u = model::side_degree(car, patch, model::Side::v0),
              v = model::side_degree(car, patch, model::Side::u0);
    const auto basis_u = model::family(family, u), basis_v = model::family(family, v);
    const model::ShapeCounts counts = model::shape_counts(family, u, v);
    const auto value = [&](const model::AnyBasis& basis, int k) {
      const int own = k % basis.shape_count();
      return std::uniform_real_distribution<double>(
          std::max(basis.shape_range(own).lower, basis.body_range(own).lower),
          std::min(basis.shape_range(own).upper, basis.body_range(own).upper))(random);
    };
    patch.basis = family;
    patch.shape_u.resize(counts.u);
    patch.shape_v.resize(counts.v);
    for (int k = 0; k < counts.u; ++k) patch.shape_u[k] = value(*basis_u, k);
    for (int k = 0; k < counts.v; ++k) patch.shape_v[k] = value(*basis_v, k);
    for (int k = 0; patch.central && k < counts.v; ++k)
      patch.shape_v[k] = patch.shape_v[std::min(k, model::mirrored_shape(*basis_v, k))];
    return;
  }
  throw std::out_of_range("no such patch: " + name);
}

model::Model car_of_families(const std::string& name, std::mt19937& random) {
  model::Model car = load_car(name);
  set_family(car, "roof", "bezier-like", random);
  set_family(car, "windshield", "h-bezier", random);
  set_family(car, "grille", "bezier-like", random);
  set_family(car, "door_upper", "bezier-like", random);
  set_family(car, "door_lower", "h-bezier", random);
  set_family(car, "side_window", "h-bezier", random);
  return car;
}

const model::EdgeCheck& edge_of(const model::BodyCheck& check, const std::string& name,
                                model::EdgeKind kind, model::Stage stage) {
  for (const model::EdgeCheck& edge : check.edges) {
    if (edge.name == name && edge.kind == kind && edge.stage == stage) return edge;
  }
  throw std::out_of_range("no such edge: " + name);
}

const model::FaceCheck& face_of(const model::BodyCheck& check, const std::string& name,
                                model::Stage stage) {
  for (const model::FaceCheck& face : check.faces) {
    if (face.name == name && face.stage == stage) return face;
  }
  throw std::out_of_range("no such face: " + name);
}

}  // namespace bodyline::testing
