#pragma once

#include <deque>
#include <vector>

#include "model/body_plan.hpp"
#include "model/cut.hpp"
#include "model/shaped_net.hpp"

namespace bodyline::model {

/// Base and kept nets of the patches that no batch builds: those of other families than GE-Bezier,
/// and those raised along a seam. They come before everything else of a construction, and their
/// pullback after everything else. Nothing is allocated after the constructor.
template <class Real>
class ShapedSteps {
 public:
  explicit ShapedSteps(const BodyPlan& plan) {
    for (const PatchStep& step : plan.patches) {
      if (step.shaped) steps_.emplace_back(step);
    }
  }

  /// Base nets, and kept nets unless `base_only`, into the array of all nets.
  void build(const Real* parameters, bool base_only, Real* nets) {
    for (Step& step : steps_) {
      read_boundary(step, parameters);
      shaped_net(step.patch, parameters + step.shape_u, parameters + step.shape_v,
                 step.boundary.data(), step.base.data());
      write(step.base, step.base_net, nets);
      if (base_only) continue;
      const Real* limit = parameters + step.cut;
      cut_matrix(step.patch.net_m, limit[0], limit[1], step.in_u.data());
      cut_matrix(step.patch.net_n, limit[2], limit[3], step.in_v.data());
      model::cut(step.patch.net_m, step.patch.net_n, step.in_u.data(), step.in_v.data(),
                 step.base.data(), step.kept.data());
      write(step.kept, step.kept_net, nets);
    }
  }

  /// After build of the same parameters: adds to the adjoints of the parameters.
  void pullback(const Real* parameters, bool base_only, const Real* nets_bar,
                Real* parameters_bar) {
    for (Step& step : steps_) {
      read(nets_bar, step.base_net, step.base_bar);
      if (!base_only) pull_back_cut(step, parameters, nets_bar, parameters_bar);
      std::fill(step.boundary_bar.begin(), step.boundary_bar.end(), Vec3<Real>{});
      shaped_net_pullback(step.patch, parameters + step.shape_u, parameters + step.shape_v,
                          step.boundary.data(), step.base_bar.data(), step.boundary_bar.data(),
                          parameters_bar + step.shape_u, parameters_bar + step.shape_v);
      for (const PatchStep::BoundaryPoint& point : step.points) {
        const Vec3<Real>& bar = step.boundary_bar[point.net_index];
        Real* at = parameters_bar + point.parameter;
        at[0] += bar.x;
        at[1] += point.mirrored ? -bar.y : bar.y;
        at[2] += bar.z;
      }
    }
  }

 private:
  struct Step {
    explicit Step(const PatchStep& step)
        : patch(step.family, step.curve_degree_u, step.curve_degree_v, step.degree_u,
                step.degree_v),
          points(step.boundary),
          shape_u(step.shape_u),
          shape_v(step.shape_v),
          cut(step.cut),
          base_net(3 * step.base_net),
          kept_net(3 * step.kept_net),
          boundary((patch.m + 1) * (patch.n + 1), Vec3<Real>{}),
          boundary_bar(boundary),
          base((patch.net_m + 1) * (patch.net_n + 1), Vec3<Real>{}),
          kept(base),
          base_bar(base),
          kept_bar(base),
          in_u((patch.net_m + 1) * (patch.net_m + 1), Real{}),
          in_v((patch.net_n + 1) * (patch.net_n + 1), Real{}) {}

    ShapedPatch patch;
    std::vector<PatchStep::BoundaryPoint> points;
    int shape_u, shape_v, cut;  // parameters
    int base_net, kept_net;     // positions in the array of all nets, in numbers
    std::vector<Vec3<Real>> boundary, boundary_bar, base, kept, base_bar, kept_bar;
    std::vector<Real> in_u, in_v;
  };

  static void read_boundary(Step& step, const Real* parameters) {
    for (const PatchStep::BoundaryPoint& point : step.points) {
      const Real* at = parameters + point.parameter;
      step.boundary[point.net_index] = {at[0], point.mirrored ? -at[1] : at[1], at[2]};
    }
  }
  static void write(const std::vector<Vec3<Real>>& net, int position, Real* nets) {
    for (const Vec3<Real>& point : net) {
      nets[position] = point.x, nets[position + 1] = point.y, nets[position + 2] = point.z;
      position += 3;
    }
  }
  static void read(const Real* nets, int position, std::vector<Vec3<Real>>& net) {
    for (Vec3<Real>& point : net) {
      point = {nets[position], nets[position + 1], nets[position + 2]};
      position += 3;
    }
  }

  // Adds to base_bar and to the adjoints of the cuts.
  static void pull_back_cut(Step& step, const Real* parameters, const Real* nets_bar,
                            Real* parameters_bar) {
    read(nets_bar, step.kept_net, step.kept_bar);
    const Real* limit = parameters + step.cut;
    const CutBar<Real> bar =
        cut_range_pullback(step.patch.net_m, step.patch.net_n, limit[1] - limit[0],
                           limit[3] - limit[2], step.kept.data(), step.kept_bar.data());
    Real* limit_bar = parameters_bar + step.cut;
    limit_bar[0] += bar.u_lo;
    limit_bar[1] += bar.u_hi;
    limit_bar[2] += bar.v_lo;
    limit_bar[3] += bar.v_hi;
    cut_pullback(step.patch.net_m, step.patch.net_n, step.in_u.data(), step.in_v.data(),
                 step.kept_bar.data(), step.base_bar.data());
  }

  std::deque<Step> steps_;
};

}  // namespace bodyline::model
