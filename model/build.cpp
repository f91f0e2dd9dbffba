#include "model/build.hpp"

#include "model/body_plan.hpp"
#include "model/construction.hpp"
#include "model/stage_surfaces.hpp"

namespace bodyline::model {

std::vector<Surface> build(const Model& model, Stage stage, Halves halves) {
  const BodyPlan plan = plan_body(model);
  Construction<double> construction(plan);
  const Eigen::VectorXd parameters = to_parameters(model, plan.layout);
  construction.build(parameters.data(), stage);
  // The points are three consecutive numbers each.
  std::vector<Surface> faces = stage_surfaces(plan, stage, &construction.nets.data()->x);
  if (halves == Halves::left_and_central) return faces;
  std::vector<Surface> both;
  for (Surface& face : faces) {
    both.push_back(std::move(face));
    if (!both.back().central) both.push_back(mirror_image(Surface(both.back())));
  }
  return both;
}

}  // namespace bodyline::model
