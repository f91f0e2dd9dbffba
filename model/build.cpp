#include "model/build.hpp"

#include "model/body_plan.hpp"
#include "model/construction.hpp"

namespace bodyline::model {
namespace {

Eigen::Vector3d to_eigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

Surface make_surface(const Face& face, const std::vector<Vec3<double>>& nets) {
  Surface surface;
  surface.name = face.name;
  surface.kind = face.kind;
  surface.degree_u = face.degree_u;
  surface.degree_v = face.degree_v;
  const int count = (face.degree_u + 1) * (face.degree_v + 1);
  for (int k = 0; k < count; ++k) surface.net.push_back(to_eigen(nets[face.net + k]));
  if (face.blend >= 0) surface.blend = to_eigen(nets[face.blend]);
  surface.central = face.central;
  surface.inward = face.inward;
  return surface;
}

}  // namespace

std::vector<Surface> build(const Model& model, Stage stage, Halves halves) {
  const BodyPlan plan = plan_body(model);
  Construction<double> construction(plan);
  const Eigen::VectorXd parameters = to_parameters(model, plan.layout);
  construction.build(parameters.data(), stage);
  std::vector<Surface> surfaces;
  for (const Face& face : plan.faces(stage)) {
    surfaces.push_back(make_surface(face, construction.nets));
    if (halves == Halves::both && !face.central)
      surfaces.push_back(mirror_image(Surface(surfaces.back())));
  }
  return surfaces;
}

}  // namespace bodyline::model
