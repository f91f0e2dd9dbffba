#pragma once

#include <array>
#include <vector>

#include "model/body_plan.hpp"
#include "model/corner_net.hpp"
#include "model/cut.hpp"
#include "model/seam.hpp"
#include "model/sq_coons.hpp"
#include "model/transition.hpp"

/// Parameters to nets, and back: the whole body, stage by stage, for any arithmetic type.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Working memory of one construction. `build` fills `nets`; `pullback` turns `nets_bar`, the adjoints of all nets, into
/// the adjoints of the parameters. Nothing is allocated after the constructor. Not for two threads at once.
template <class Real>
class Construction {
 public:
  explicit Construction(const BodyPlan& plan)
      : nets(plan.point_count),
        nets_bar(plan.point_count),
        plan_(&plan),
        kept_(plan.kept_begin),
        cuts_(2 * plan.patches.size()),
        seams_before_(plan.seams.size()),
        seam_traces_(plan.seams.size()),
        uncut_(plan.joints.size()),
        corner_traces_(plan.corners.size()) {}

  std::vector<Vec3<Real>> nets;      ///< all nets at the offsets of the plan
  std::vector<Vec3<Real>> nets_bar;  ///< adjoints; pullback overwrites parts of it

  /// Nets of all stages up to `stage` from the parameters (layout.size() of them).
  /// `for_pullback` also prepares what `pullback` needs.
  void build(const Real* parameters, Stage stage, bool for_pullback) {
    for (std::size_t p = 0; p < plan_->patches.size(); ++p) build_base(parameters, plan_->patches[p]);
    if (stage == Stage::base) return;
    for (std::size_t p = 0; p < plan_->patches.size(); ++p) build_kept(parameters, p, for_pullback);
    for (std::size_t s = 0; s < plan_->seams.size(); ++s) build_seam(s);
    if (stage == Stage::kept) return;
    for (std::size_t j = 0; j < plan_->joints.size(); ++j) build_transition(parameters, j);
    for (std::size_t c = 0; c < plan_->corners.size(); ++c) build_corner(c);
  }

  /// After build(parameters, stage, true): adds d / d parameter to `parameters_bar`. Consumes nets_bar.
  void pullback(const Real* parameters, Stage stage, Real* parameters_bar) {
    if (stage == Stage::body) {
      for (std::size_t c = plan_->corners.size(); c-- > 0;) corner_pullback(c);
      for (std::size_t j = plan_->joints.size(); j-- > 0;) transition_pullback(parameters, j, parameters_bar);
    }
    if (stage != Stage::base) {
      for (std::size_t s = plan_->seams.size(); s-- > 0;) seam_pullback(s);
      for (std::size_t p = plan_->patches.size(); p-- > 0;) kept_pullback(parameters, p, parameters_bar);
    }
    for (std::size_t p = plan_->patches.size(); p-- > 0;) base_pullback(parameters, plan_->patches[p], parameters_bar);
  }

 private:
  void build_base(const Real* parameters, const PatchStep& step) {
    Vec3<Real>* net = &nets[step.base_net];
    for (const PatchStep::BoundaryPoint& b : step.boundary) {
      const Real* p = parameters + b.parameter;
      net[b.net_index] = {p[0], b.mirrored ? -p[1] : p[1], p[2]};
    }
    sq_coons(step.degree_u, step.degree_v, net, parameters + step.shape_u, parameters + step.shape_v);
  }

  void base_pullback(const Real* parameters, const PatchStep& step, Real* parameters_bar) {
    Vec3<Real>* bar = &nets_bar[step.base_net];
    sq_coons_pullback(step.degree_u, step.degree_v, &nets[step.base_net], parameters + step.shape_u,
                      parameters + step.shape_v, bar, parameters_bar + step.shape_u, parameters_bar + step.shape_v);
    for (const PatchStep::BoundaryPoint& b : step.boundary) {
      Real* p = parameters_bar + b.parameter;
      const Vec3<Real>& at = bar[b.net_index];
      p[0] += at.x;
      p[1] += b.mirrored ? -at.y : at.y;
      p[2] += at.z;
    }
  }

  void build_kept(const Real* parameters, std::size_t p, bool) {
    const PatchStep& step = plan_->patches[p];
    const Real* c = parameters + step.cut;
    cut_matrix(step.degree_u, c[0], c[1], cuts_[2 * p].data());
    cut_matrix(step.degree_v, c[2], c[3], cuts_[2 * p + 1].data());
    cut(step.degree_u, step.degree_v, cuts_[2 * p].data(), cuts_[2 * p + 1].data(), &nets[step.base_net],
        &nets[step.kept_net]);
    const int points = (step.degree_u + 1) * (step.degree_v + 1);
    for (int k = 0; k < points; ++k) kept_[step.base_net + k] = nets[step.kept_net + k];
  }

  void kept_pullback(const Real* parameters, std::size_t p, Real* parameters_bar) {
    const PatchStep& step = plan_->patches[p];
    const Real* at = parameters + step.cut;
    const int m = step.degree_u, n = step.degree_v;
    const Vec3<Real>*kept = &kept_[step.base_net], *bar = &nets_bar[step.kept_net];
    const RangeBar<Real> u = cut_range_pullback(m, n + 1, n + 1, 1, at[1] - at[0], kept, bar);
    const RangeBar<Real> v = cut_range_pullback(n, 1, m + 1, n + 1, at[3] - at[2], kept, bar);
    Real* c = parameters_bar + step.cut;
    c[0] += u.lo;
    c[1] += u.hi;
    c[2] += v.lo;
    c[3] += v.hi;
    cut_pullback(m, n, cuts_[2 * p].data(), cuts_[2 * p + 1].data(), bar, &nets_bar[step.base_net]);
  }

  int kept_index(const SideStep& side, int k, int depth) const {
    return plan_->patches[side.patch].kept_net + side.walk.start + k * side.walk.step + depth * side.walk.inward;
  }

  void build_seam(std::size_t s) {
    const SeamStep& step = plan_->seams[s];
    SeamRows<Real>& before = seams_before_[s];
    for (int k = 0; k <= step.degree; ++k) {
      before.edge[k] = nets[kept_index(step.a, k, 0)];
      before.across_a[k] = before.edge[k] - nets[kept_index(step.a, k, 1)];
      before.across_b[k] = nets[kept_index(step.b, k, 1)] - before.edge[k];
    }
    SeamRows<Real> rows = before;
    correct_seam(step.degree, rows, seam_traces_[s]);
    for (int k = 0; k <= step.degree; ++k) {
      nets[kept_index(step.a, k, 1)] = rows.edge[k] - rows.across_a[k];
      nets[kept_index(step.b, k, 1)] = rows.edge[k] + rows.across_b[k];
    }
  }

  void seam_pullback(std::size_t s) {
    const SeamStep& step = plan_->seams[s];
    SeamRows<Real> bar{};
    for (int k = 0; k <= step.degree; ++k) {
      Vec3<Real>&second_a = nets_bar[kept_index(step.a, k, 1)], &second_b = nets_bar[kept_index(step.b, k, 1)];
      bar.edge[k] = second_a + second_b;
      bar.across_a[k] = -second_a;
      bar.across_b[k] = second_b;
      second_a = second_b = Vec3<Real>{};
    }
    correct_seam_pullback(step.degree, seams_before_[s], seam_traces_[s], bar);
    for (int k = 0; k <= step.degree; ++k) {
      nets_bar[kept_index(step.a, k, 1)] -= bar.across_a[k];
      nets_bar[kept_index(step.b, k, 1)] += bar.across_b[k];
      nets_bar[kept_index(step.a, k, 0)] += bar.edge[k] + bar.across_a[k] - bar.across_b[k];
    }
  }

  // Reads one side of a joint from the kept nets; for an uncut side the stretch is that of the whole patch.
  TransitionSide<Real> read_side(const Real* parameters, const JointStep& step, int which) const {
    const SideStep& side = step.side[which];
    TransitionSide<Real> read;
    for (int k = 0; k <= step.degree; ++k) {
      read.edge[k] = nets[kept_index(side, k, 0)];
      read.second[k] = nets[kept_index(side, k, 1)];
    }
    const Real kept = parameters[side.cut_lo + 1] - parameters[side.cut_lo];
    const Real width = step.uncut == which ? Real(1.0) : cut_width(parameters, side);
    read.stretch = Real(double(side.walk.across)) * width / kept;
    read.fullness = parameters[step.fullness[which]];
    read.lean[0] = parameters[step.lean[which]];
    read.lean[1] = parameters[step.lean[which] + 1];
    return read;
  }

  static Real cut_width(const Real* parameters, const SideStep& side) {
    const Real& value = parameters[side.cut_at];
    return side.at_upper ? Real(1.0) - value : value;
  }

  // The free edge beyond an uncut side, as a derivative over the discarded strip of the other patch.
  void free_edge_targets(const Real* parameters, const JointStep& step, Vec3<Real>* target) const {
    const SideStep& other = step.side[1 - step.uncut];
    const Vec3<Real>* base = &nets[plan_->patches[other.patch].base_net];
    const Real reach = Real(double(other.walk.across)) * cut_width(parameters, other);
    for (int end = 0; end < 2; ++end) {
      target[end] = reach * (base[step.free_edge[end][1]] - base[step.free_edge[end][0]]);
    }
  }

  void build_transition(const Real* parameters, std::size_t j) {
    const JointStep& step = plan_->joints[j];
    Vec3<Real>* net = &nets[step.net];
    Vec3<Real> edge[max_patch_degree + 2], handle[max_patch_degree + 2];
    for (int which = 0; which < 2; ++which) {
      const TransitionSide<Real> side = read_side(parameters, step, which);
      if (step.uncut == which) {
        Vec3<Real> target[2];
        free_edge_targets(parameters, step, target);
        uncut_handle(step.degree, side, target, cut_width(parameters, step.side[1 - which]), edge, handle, uncut_[j]);
      } else if (step.uncut >= 0) {
        Vec3<Real> low[max_patch_degree + 1];
        transition_handle(step.degree, side, step.leaning[which], low);
        elevate_once(step.degree, side.edge, edge);
        elevate_once(step.degree, low, handle);
      } else {
        transition_handle(step.degree, side, step.leaning[which], handle);
        for (int k = 0; k <= step.degree; ++k) edge[k] = side.edge[k];
      }
      const int edge_row = which == 0 ? 0 : 3, handle_row = which == 0 ? 1 : 2;
      for (int k = 0; k <= step.net_degree; ++k) {
        net[4 * k + edge_row] = edge[k];
        net[4 * k + handle_row] = handle[k];
      }
    }
  }

  void transition_pullback(const Real* parameters, std::size_t j, Real* parameters_bar) {
    const JointStep& step = plan_->joints[j];
    const Vec3<Real>* net_bar = &nets_bar[step.net];
    Vec3<Real> edge_bar[max_patch_degree + 2], handle_bar[max_patch_degree + 2];
    for (int which = 0; which < 2; ++which) {
      const int edge_row = which == 0 ? 0 : 3, handle_row = which == 0 ? 1 : 2;
      for (int k = 0; k <= step.net_degree; ++k) {
        edge_bar[k] = net_bar[4 * k + edge_row];
        handle_bar[k] = net_bar[4 * k + handle_row];
      }
      const TransitionSide<Real> side = read_side(parameters, step, which);
      TransitionSide<Real> bar{};
      if (step.uncut == which) {
        Vec3<Real> target[2], target_bar[2] = {};
        free_edge_targets(parameters, step, target);
        Real width_bar{};
        uncut_handle_pullback(step.degree, side, target, cut_width(parameters, step.side[1 - which]), uncut_[j],
                              edge_bar, handle_bar, bar, target_bar, width_bar);
        free_edge_pullback(parameters, step, target_bar, width_bar, parameters_bar);
      } else if (step.uncut >= 0) {
        Vec3<Real> low_bar[max_patch_degree + 1] = {};
        elevate_once_pullback(step.degree, edge_bar, bar.edge);
        elevate_once_pullback(step.degree, handle_bar, low_bar);
        transition_handle_pullback(step.degree, side, step.leaning[which], low_bar, bar);
      } else {
        for (int k = 0; k <= step.degree; ++k) bar.edge[k] = edge_bar[k];
        transition_handle_pullback(step.degree, side, step.leaning[which], handle_bar, bar);
      }
      side_pullback(parameters, step, which, side, bar, parameters_bar);
    }
  }

  void side_pullback(const Real* parameters, const JointStep& step, int which, const TransitionSide<Real>& side,
                     const TransitionSide<Real>& bar, Real* parameters_bar) {
    const SideStep& at = step.side[which];
    for (int k = 0; k <= step.degree; ++k) {
      nets_bar[kept_index(at, k, 0)] += bar.edge[k];
      nets_bar[kept_index(at, k, 1)] += bar.second[k];
    }
    const Real kept = parameters[at.cut_lo + 1] - parameters[at.cut_lo];
    const Real kept_bar = -bar.stretch * side.stretch / kept;
    parameters_bar[at.cut_lo + 1] += kept_bar;
    parameters_bar[at.cut_lo] -= kept_bar;
    if (step.uncut != which) {
      const Real width_bar = bar.stretch * Real(double(at.walk.across)) / kept;
      parameters_bar[at.cut_at] += at.at_upper ? -width_bar : width_bar;
    }
    parameters_bar[step.fullness[which]] += bar.fullness;
    parameters_bar[step.lean[which]] += bar.lean[0];
    parameters_bar[step.lean[which] + 1] += bar.lean[1];
  }

  // `width_bar` is the adjoint of the other side's cut width from elsewhere.
  void free_edge_pullback(const Real* parameters, const JointStep& step, const Vec3<Real>* target_bar, Real width_bar,
                          Real* parameters_bar) {
    const SideStep& other = step.side[1 - step.uncut];
    const int base = plan_->patches[other.patch].base_net;
    const Real across(double(other.walk.across));
    const Real reach = across * cut_width(parameters, other);
    Real reach_bar{};
    for (int end = 0; end < 2; ++end) {
      const int at = base + step.free_edge[end][0], next = base + step.free_edge[end][1];
      reach_bar += dot(target_bar[end], nets[next] - nets[at]);
      nets_bar[next] += reach * target_bar[end];
      nets_bar[at] -= reach * target_bar[end];
    }
    width_bar += across * reach_bar;
    parameters_bar[other.cut_at] += other.at_upper ? -width_bar : width_bar;
  }

  // Indices in the arena of the end row of a transition and of the row next to it, point t of the corner's edge.
  struct EndRows {
    int at[4], next[4];
    double degree;
  };
  EndRows end_rows(const CornerEdgeLink& edge) const {
    const JointStep& joint = plan_->joints[edge.joint];
    const int n = joint.net_degree;
    EndRows rows;
    rows.degree = n;
    for (int t = 0; t < 4; ++t) {
      const int column = edge.reversed ? 3 - t : t;
      rows.at[t] = joint.net + 4 * (edge.end == 0 ? 0 : n) + column;
      rows.next[t] = joint.net + 4 * (edge.end == 0 ? 1 : n - 1) + column;
    }
    return rows;
  }

  void read_edges(const CornerStep& step, TransitionEnd<Real>* edges) const {
    for (int e = 0; e < 4; ++e) {
      if (step.shape.three_sided && e == top) continue;
      const EndRows rows = end_rows(step.edges[e]);
      for (int t = 0; t < 4; ++t) {
        edges[e].curve[t] = nets[rows.at[t]];
        edges[e].inward[t] = scaled(rows.degree, nets[rows.at[t]] - nets[rows.next[t]]);
      }
    }
    if (step.shape.three_sided) {
      for (int t = 0; t < 4; ++t) {
        edges[top].curve[t] = edges[left].curve[3];
        edges[top].inward[t] = Vec3<Real>{};
      }
    }
  }

  void build_corner(std::size_t c) {
    const CornerStep& step = plan_->corners[c];
    TransitionEnd<Real> edges[4];
    read_edges(step, edges);
    corner_net(step.shape, edges, corner_traces_[c], &nets[step.net], &nets[step.blend]);
  }

  void corner_pullback(std::size_t c) {
    const CornerStep& step = plan_->corners[c];
    TransitionEnd<Real> edges[4], edges_bar[4] = {};
    read_edges(step, edges);
    corner_net_pullback(step.shape, edges, corner_traces_[c], &nets_bar[step.net], nets_bar[step.blend], edges_bar);
    if (step.shape.three_sided) {
      for (int t = 0; t < 4; ++t) edges_bar[left].curve[3] += edges_bar[top].curve[t];
    }
    for (int e = 0; e < 4; ++e) {
      if (step.shape.three_sided && e == top) continue;
      const EndRows rows = end_rows(step.edges[e]);
      for (int t = 0; t < 4; ++t) {
        const Vec3<Real> inward_bar = scaled(rows.degree, edges_bar[e].inward[t]);
        nets_bar[rows.at[t]] += edges_bar[e].curve[t] + inward_bar;
        nets_bar[rows.next[t]] -= inward_bar;
      }
    }
  }

  const BodyPlan* plan_;
  std::vector<Vec3<Real>> kept_;  // before the seams
  std::vector<std::array<Real, (max_patch_degree + 1) * (max_patch_degree + 1)>> cuts_;
  std::vector<SeamRows<Real>> seams_before_;
  std::vector<SeamTrace<Real>> seam_traces_;
  std::vector<UncutTrace<Real>> uncut_;
  std::vector<CornerTrace<Real>> corner_traces_;
};

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
