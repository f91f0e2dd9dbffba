#include "model/build.hpp"

#include "model/body_plan.hpp"
#include "model/construction.hpp"
#include "model/net_surface.hpp"

namespace bodyline::model {
std::vector<Surface> build(const Model& model, Stage stage, Halves halves) {
  const BodyPlan plan = plan_body(model);
  Construction<double> construction(plan);
  const Eigen::VectorXd parameters = to_parameters(model, plan.layout);
  construction.build(parameters.data(), stage);
  const double* const nets = &construction.nets.front().x;
  std::vector<Surface> surfaces;
  for (const Face& face : plan.faces(stage)) {
    surfaces.push_back(net_surface(face, nets));
    if (halves == Halves::both && !face.central)
      surfaces.push_back(mirror_image(Surface(surfaces.back())));
  }
  return surfaces;
}

}  // namespace bodyline::model
