#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "io/read_model.hpp"
#include "model/build.hpp"
#include "model/evaluator.hpp"
#include "model/scan.hpp"
#include "optimize/rim_samples.hpp"

namespace bodyline::optimize {

/// The nets of a car of the repository at a stage.
struct CarNets {
  explicit CarNets(model::Stage chosen)
      : stage(chosen),
        car(io::read_model(BODYLINE_SOURCE_DIR "/cars/model2.toml")),
        context(std::make_shared<const model::BodyContext>(car)) {
    model::EvaluatorOptions options;
    options.stage = stage;
    evaluator = std::make_unique<model::Evaluator>(
        context, context->map.select(std::vector<std::string>{"*"}), options);
    evaluator->build_parameters(context->parameters);
  }
  const double* nets() const { return evaluator->nets(); }
  std::vector<double> copy() const {
    return {nets(), nets() + 3 * std::size_t(context->plan.point_count)};
  }

  model::Stage stage;
  model::Model car;
  std::shared_ptr<const model::BodyContext> context;
  std::unique_ptr<model::Evaluator> evaluator;
};

/// Points of all rims of a car, `count` of each.
inline std::vector<RimSample> samples_of_rims(const CarNets& car, int count) {
  std::vector<RimSample> all;
  for (const Rim& rim : rim_list(car.context->plan, car.stage)) {
    const model::Face& face = car.context->plan.faces(car.stage)[std::size_t(rim.face)];
    const auto own = rim_samples(rim, face, car.nets() + 3 * face.net, count);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

/// Points up to `away` mm off the left half of the body, with its normals; u and v are at least
/// `inset` from the edges of the faces.
inline model::Scan points_off(const CarNets& car, int count, double away, double inset) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * double(random()) / double(std::mt19937::max());
  };
  const auto faces = model::build(car.car, car.stage, model::Halves::left_and_central);
  model::Scan scan;
  for (int k = 0; k < count; ++k) {
    const model::Surface& face = faces[std::size_t(k) % faces.size()];
    const double u = uniform(inset, 1.0 - inset), v = uniform(inset, 1.0 - inset);
    const Eigen::Vector3d normal = model::outward_normal(face, u, v);
    scan.points.push_back(model::jet(face, u, v, 0).d[0] + uniform(-away, away) * normal);
    scan.normals.push_back(normal);
  }
  return scan;
}

}  // namespace bodyline::optimize
