#include "check_models.hpp"

#include <stdexcept>

#include "io/read_model.hpp"
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
