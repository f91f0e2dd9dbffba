#include "model/check_warnings.hpp"

#include "model/construction.hpp"

namespace bodyline::model {
namespace {

// The part of the free edge's way across that the plain construction would go, at one end of an
// uncut side: below least_uncut_reach it is lifted.
double plain_reach(const JointStep& step, const BodyPlan& plan, const Eigen::VectorXd& parameters,
                   const std::vector<Vec3<double>>& nets, int end) {
  const SideStep& side = step.side[step.uncut];
  const SideStep& other = step.side[1 - step.uncut];
  const PatchStep& patch = plan.patches[side.patch];
  const Vec3<double>* kept = &nets[patch.kept_net];
  const int at = side.walk.start + (end == 0 ? 0 : step.degree * side.walk.step);
  const int next = at + (end == 0 ? side.walk.step : -side.walk.step);
  const double width = parameters[side.cut_lo + 1] - parameters[side.cut_lo];
  const double value = parameters[other.cut_at];
  const double neighbour = other.at_upper ? 1.0 - value : value;
  const Vec3<double> across =
      scaled(side.walk.across / width, kept[at] - kept[at + side.walk.inward]);
  const Vec3<double>* base = &nets[plan.patches[other.patch].base_net];
  const Vec3<double> free_edge = scaled(
      other.walk.across * neighbour, base[step.free_edge[end][1]] - base[step.free_edge[end][0]]);
  return plane_solve(across, kept[next] - kept[at], free_edge).p / neighbour;
}

std::string lifted_sentence(const Model& model, int joint, int end) {
  const Joint& at = model.joints[joint];
  const PatchSide &uncut = *at.uncut == 0 ? at.a : at.b, &other = *at.uncut == 0 ? at.b : at.a;
  return at.name + ": at end " + std::to_string(end) + " the free edge of " +
         model.patches[other.patch].name + " does not lead away from " +
         model.patches[uncut.patch].name +
         ", which is not cut back; the transition leaves that edge so as not to fold.";
}

}  // namespace

std::vector<std::string> body_warnings(const Model& model, const BodyPlan& plan, Stage stage) {
  std::vector<std::string> warnings;
  if (stage != Stage::body) return warnings;
  Construction<double> construction(plan);
  const Eigen::VectorXd parameters = to_parameters(model, plan.layout);
  construction.build(parameters.data(), Stage::kept);
  for (std::size_t c = 0; c < plan.corners.size(); ++c) {
    if (!plan.corners[c].shape.seam) continue;
    warnings.push_back(model.corners[c].name +
                       ": the corner patch is not polynomial; it has a Gregory term where the "
                       "seam ends.");
  }
  for (std::size_t j = 0; j < plan.joints.size(); ++j) {
    if (plan.joints[j].uncut < 0) continue;
    for (int end = 0; end < 2; ++end) {
      const double reach = plain_reach(plan.joints[j], plan, parameters, construction.nets, end);
      if (!(reach >= least_uncut_reach)) warnings.push_back(lifted_sentence(model, int(j), end));
    }
  }
  return warnings;
}

}  // namespace bodyline::model
