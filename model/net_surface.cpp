#include "model/net_surface.hpp"

namespace bodyline::model {

Surface net_surface(const Face& face, const double* nets) {
  const auto point = [nets](int index) { return Eigen::Vector3d(nets + 3 * index); };
  Surface surface;
  surface.name = face.name;
  surface.kind = face.kind;
  surface.degree_u = face.degree_u;
  surface.degree_v = face.degree_v;
  const int count = (face.degree_u + 1) * (face.degree_v + 1);
  for (int k = 0; k < count; ++k) surface.net.push_back(point(face.net + k));
  if (face.blend >= 0) surface.blend = point(face.blend);
  surface.central = face.central;
  surface.inward = face.inward;
  return surface;
}

std::vector<Surface> net_surfaces(const BodyPlan& plan, Stage stage, const double* nets) {
  std::vector<Surface> surfaces;
  for (const Face& face : plan.faces(stage)) surfaces.push_back(net_surface(face, nets));
  return surfaces;
}

}  // namespace bodyline::model
