#include "model/check_warnings.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace bodyline::model {
namespace {

using Eigen::Vector3d;

constexpr double followed = 1e-6;  // radians: what is more is no rounding

// The angle between the transition and the free edge beyond, seen in the tangent plane of the uncut
// side at one end of its joint.
double angle_to_free_edge(const BodyPlan& plan, int joint, int end,
                          const std::vector<Surface>& base, const std::vector<Surface>& body) {
  const JointStep& step = plan.joints[joint];
  const SideStep& side = step.side[step.uncut];
  const std::vector<Vector3d>& kept = body[side.patch].net;
  const std::vector<Vector3d>& whole = base[step.side[1 - step.uncut].patch].net;
  const Surface& transition = body[plan.patches.size() + joint];
  const int corner = side.walk.start + (end == 0 ? 0 : (side.walk.count - 1) * side.walk.step);
  const int along = corner + (end == 0 ? side.walk.step : -side.walk.step);
  const Vector3d normal =
      (kept[along] - kept[corner]).cross(kept[corner + side.walk.inward] - kept[corner]);
  const int row = end == 0 ? 0 : step.net_degree;
  const Vector3d handle =
      step.uncut == 0
          ? Vector3d(transition.point(row, 1) - transition.point(row, 0))
          : Vector3d(transition.point(row, step.across - 1) - transition.point(row, step.across));
  const Vector3d free_edge = whole[step.free_edge[end][1]] - whole[step.free_edge[end][0]];
  // Turned by a right angle in the plane, both keep the angle between them.
  const Vector3d a = normal.cross(handle), b = normal.cross(free_edge);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::string not_followed_sentence(const Model& model, int joint, int end) {
  const Joint& at = model.joints[joint];
  const PatchSide &uncut = *at.uncut == 0 ? at.a : at.b, &other = *at.uncut == 0 ? at.b : at.a;
  return at.name + ": at end " + std::to_string(end) + " the free edge of " +
         model.patches[other.patch].name + " does not lead away from " +
         model.patches[uncut.patch].name +
         ", which is not cut back; the transition leaves that edge so as not to fold.";
}

}  // namespace

std::vector<std::string> body_warnings(const Model& model, const BodyPlan& plan,
                                       const std::vector<Surface>& base,
                                       const std::vector<Surface>& body) {
  std::vector<std::string> warnings;
  for (std::size_t c = 0; c < plan.corners.size(); ++c) {
    if (!plan.corners[c].shape.seam) continue;
    warnings.push_back(model.corners[c].name +
                       ": the corner patch is not polynomial; it has a Gregory term where the "
                       "seam ends.");
  }
  for (int j = 0; j < int(plan.joints.size()); ++j) {
    if (plan.joints[j].uncut < 0) continue;
    for (int end = 0; end < 2; ++end) {
      const double angle = angle_to_free_edge(plan, j, end, base, body);
      if (!(angle <= followed)) warnings.push_back(not_followed_sentence(model, j, end));
    }
  }
  return warnings;
}

}  // namespace bodyline::model
