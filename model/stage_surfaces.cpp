#include "model/stage_surfaces.hpp"

namespace bodyline::model {

std::vector<Surface> stage_surfaces(const BodyPlan& plan, Stage stage, const double* nets) {
  const auto point = [nets](int at) {
    return Eigen::Vector3d(nets[3 * at], nets[3 * at + 1], nets[3 * at + 2]);
  };
  std::vector<Surface> surfaces;
  for (const Face& face : plan.faces(stage)) {
    Surface& surface = surfaces.emplace_back();
    surface.name = face.name;
    surface.kind = face.kind;
    surface.degree_u = face.degree_u;
    surface.degree_v = face.degree_v;
    const int count = (face.degree_u + 1) * (face.degree_v + 1);
    for (int k = 0; k < count; ++k) surface.net.push_back(point(face.net + k));
    if (face.blend >= 0) surface.blend = point(face.blend);
    surface.central = face.central;
    surface.inward = face.inward;
  }
  return surfaces;
}

}  // namespace bodyline::model
