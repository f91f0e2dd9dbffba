#include "model/batch_plan.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "model/batch_bends.hpp"
#include "model/batch_memory.hpp"

namespace bodyline::model {
namespace {

constexpr int numbers_per_point = 3;
constexpr int alignment = 8;         // of memory, in numbers
constexpr int narrowest_vector = 4;  // what has fewer lanes than this is built one step at a time

template <class Memory>
constexpr int memory_numbers() {
  return int(sizeof(Memory) / sizeof(double));
}

// The numbers of a side's row in the array of all nets, point by point.
int row_point(const BodyPlan& plan, const SideStep& side, int k, int depth) {
  return numbers_per_point * (plan.patches[side.patch].kept_net + side.walk.start +
                              k * side.walk.step + depth * side.walk.inward);
}

// One side of a joint.
struct JointSide {
  const JointStep* joint;
  int which;
  const SideStep& side() const { return joint->side[which]; }
};

}  // namespace

/// Fills a BatchPlan; each kind of batch has its function.
class BatchPlanner {
 public:
  BatchPlanner(BatchPlan& result, const BodyPlan& plan, int lanes)
      : result_(result), plan_(plan), lanes_(lanes) {}

  void plan_patches() {
    std::map<std::pair<int, int>, std::vector<const PatchStep*>> groups;
    for (const PatchStep& patch : plan_.patches) {
      if (!patch.shaped) groups[{patch.degree_u, patch.degree_v}].push_back(&patch);
    }
    for (const auto& [degrees, group] : groups) {
      for_each_batch(group, [&](const std::vector<const PatchStep*>& steps, int count) {
        add_patches(steps, count);
      });
    }
  }

  // Seams in order; one that shares a point with another waits for a later batch.
  void plan_seams() {
    std::vector<const SeamStep*> group;
    std::set<int> points;
    const auto flush = [&] {
      for_each_batch(group, [&](const std::vector<const SeamStep*>& steps, int count) {
        add_seams(steps, count);
      });
      group.clear();
      points.clear();
    };
    for (const SeamStep& seam : plan_.seams) {
      std::set<int> own;
      for (int k = 0; k <= seam.degree; ++k) {
        own.insert({row_point(plan_, seam.a, k, 0), row_point(plan_, seam.b, k, 0),
                    row_point(plan_, seam.a, k, 1), row_point(plan_, seam.b, k, 1)});
      }
      const bool shares =
          std::any_of(own.begin(), own.end(), [&](int point) { return points.contains(point); });
      if (shares || (!group.empty() && group.front()->degree != seam.degree)) flush();
      group.push_back(&seam);
      points.merge(own);
    }
    flush();
  }

  void plan_sides() {
    std::map<std::tuple<SideKind, int, bool, int>, std::vector<JointSide>> groups;
    for (const JointStep& joint : plan_.joints) {
      for (int which = 0; which < 2; ++which) {
        const int degree = joint.side[which].walk.count - 1, raise = joint.net_degree - degree;
        const SideKind kind = side_kind(joint, which);
        if (joint.continuity == 2) {
          add_bend_side(kind, {{&joint, which}});
        } else {
          groups[{kind, degree, joint.leaning[which], raise}].push_back({&joint, which});
        }
      }
    }
    for (const auto& [signature, group] : groups) {
      const SideKind kind = std::get<SideKind>(signature);
      for_each_batch(group, [&](const std::vector<JointSide>& sides, int count) {
        add_sides(kind, sides, count);
      });
    }
  }

  void plan_corners() {
    std::vector<const CornerStep*> group;
    for (const CornerStep& corner : plan_.corners) {
      if (corner.across == bend_degree) {
        result_.bend_corners_.push_back(
            corner_batch({&corner}, 1, memory_numbers<CornerMemory<double, bend_degree>>()));
      } else {
        group.push_back(&corner);
      }
    }
    std::stable_partition(group.begin(), group.end(),
                          [](const CornerStep* c) { return !c->shape.three_sided; });
    for_each_batch(group, [&](const std::vector<const CornerStep*>& steps, int count) {
      result_.corners_.push_back(
          corner_batch(steps, count, memory_numbers<CornerMemory<double>>()));
    });
  }

  void finish() {
    BatchTables& tables = result_.tables_;
    tables.number_count = numbers_per_point * plan_.point_count;
    tables.memory = memory_;
    tables.patch_count = int(result_.patches_.size());
    tables.seam_count = int(result_.seams_.size());
    tables.side_count = int(result_.sides_.size());
    tables.corner_count = int(result_.corners_.size());
    tables.patches = result_.patches_.data();
    tables.seams = result_.seams_.data();
    tables.sides = result_.sides_.data();
    tables.corners = result_.corners_.data();
    tables.bend_side_count = int(result_.bend_sides_.size());
    tables.bend_corner_count = int(result_.bend_corners_.size());
    tables.bend_sides = result_.bend_sides_.data();
    tables.bend_corners = result_.bend_corners_.data();
  }

 private:
  // How many lanes the next batch of `left` steps gets.
  int next_lanes(int left) const {
    const int half = lanes_ / 2;
    if (left >= lanes_) return lanes_;
    if (left == 1 || half < 2) return left == 1 ? 1 : lanes_;
    if (half < narrowest_vector) return lanes_;
    return left <= half + 1 ? half : lanes_;
  }

  // Cuts a group into batches; where lanes are left over they repeat the last step.
  template <class Step, class Add>
  void for_each_batch(const std::vector<Step>& group, const Add& add) {
    std::size_t first = 0;
    while (first < group.size()) {
      const int lanes = next_lanes(int(group.size() - first));
      const int count = std::min(lanes, int(group.size() - first));
      std::vector<Step> steps(group.begin() + first, group.begin() + first + count);
      steps.resize(lanes, steps.back());
      add(steps, count);
      first += count;
    }
  }

  // A table with `rows` entries for every step: value(step, row).
  template <class Step, class Value>
  const int* offsets(const std::vector<Step>& steps, int rows, const Value& value) {
    std::vector<int>& table = result_.offsets_.emplace_back();
    for (int row = 0; row < rows; ++row) {
      for (const Step& step : steps) table.push_back(value(step, row));
    }
    return table.data();
  }
  template <class Step, class Value>
  const double* numbers(const std::vector<Step>& steps, int rows, const Value& value) {
    std::vector<double>& table = result_.numbers_.emplace_back();
    for (int row = 0; row < rows; ++row) {
      for (const Step& step : steps) table.push_back(value(step, row));
    }
    return table.data();
  }

  // A place for what a batch keeps: so many numbers of each lane.
  int take_memory(std::size_t lanes, int of_each_lane) {
    const int at = memory_;
    memory_ += (int(lanes) * of_each_lane + alignment - 1) / alignment * alignment;
    return at;
  }

  void add_patches(const std::vector<const PatchStep*>& steps, int count) {
    using Step = const PatchStep*;
    const PatchStep& first = *steps.front();
    PatchBatch batch;
    batch.degree_u = first.degree_u;
    batch.degree_v = first.degree_v;
    batch.lanes = int(steps.size());
    batch.count = count;
    batch.memory = take_memory(steps.size(), patch_memory_numbers(first.degree_u, first.degree_v));
    batch.boundary_count = int(first.boundary.size());
    std::vector<int>& indices = result_.offsets_.emplace_back();
    for (const PatchStep::BoundaryPoint& point : first.boundary) indices.push_back(point.net_index);
    batch.boundary_net = indices.data();
    batch.boundary = offsets(steps, batch.boundary_count,
                             [](Step step, int k) { return step->boundary[k].parameter; });
    batch.boundary_sign = numbers(steps, batch.boundary_count, [](Step step, int k) {
      return step->boundary[k].mirrored ? -1.0 : 1.0;
    });
    batch.base =
        offsets(steps, 1, [](Step step, int) { return numbers_per_point * step->base_net; });
    batch.kept =
        offsets(steps, 1, [](Step step, int) { return numbers_per_point * step->kept_net; });
    batch.shape_u = offsets(steps, 1, [](Step step, int) { return step->shape_u; });
    batch.shape_v = offsets(steps, 1, [](Step step, int) { return step->shape_v; });
    batch.cut = offsets(steps, 1, [](Step step, int) { return step->cut; });
    result_.patches_.push_back(batch);
  }

  void add_seams(const std::vector<const SeamStep*>& steps, int count) {
    using Step = const SeamStep*;
    SeamBatch batch;
    batch.degree = steps.front()->degree;
    batch.lanes = int(steps.size());
    batch.count = count;
    batch.memory = take_memory(steps.size(), memory_numbers<SeamMemory<double>>());
    const int points = batch.degree + 1;
    batch.edge =
        offsets(steps, points, [&](Step step, int k) { return row_point(plan_, step->a, k, 0); });
    batch.second_a =
        offsets(steps, points, [&](Step step, int k) { return row_point(plan_, step->a, k, 1); });
    batch.second_b =
        offsets(steps, points, [&](Step step, int k) { return row_point(plan_, step->b, k, 1); });
    result_.seams_.push_back(batch);
  }

  // Width of the strip cut from side(step), or 1 where it is not cut.
  template <class SideOf>
  WidthTable width_table(const std::vector<JointSide>& sides, bool is_cut, const SideOf& side_of) {
    WidthTable table;
    table.parameter =
        offsets(sides, 1, [&](const JointSide& at, int) { return side_of(at).cut_at; });
    table.offset = numbers(sides, 1, [&](const JointSide& at, int) {
      return !is_cut || side_of(at).at_upper ? 1.0 : 0.0;
    });
    table.factor = numbers(sides, 1, [&](const JointSide& at, int) {
      return !is_cut ? 0.0 : (side_of(at).at_upper ? -1.0 : 1.0);
    });
    return table;
  }

  static SideKind side_kind(const JointStep& joint, int which) {
    if (joint.uncut == which) return SideKind::uncut;
    return joint.net_degree > joint.side[which].walk.count - 1 ? SideKind::raised : SideKind::plain;
  }

  void add_sides(SideKind kind, const std::vector<JointSide>& sides, int count) {
    result_.sides_.push_back(side_batch(kind, sides, count, memory_numbers<SideMemory<double>>()));
  }

  void add_bend_side(SideKind kind, const std::vector<JointSide>& side) {
    SideBatch batch = side_batch(kind, side, 1, memory_numbers<BendSideMemory<double>>());
    using At = const JointSide&;
    batch.third = offsets(side, batch.degree + 1,
                          [&](At at, int k) { return row_point(plan_, at.side(), k, 2); });
    batch.bend_row = offsets(side, 1, [](At at, int) { return row_of(at, 2); });
    result_.bend_sides_.push_back(batch);
  }

  // The first point of row `depth` of a transition, counted from one side of its joint.
  static int row_of(const JointSide& at, int depth) {
    const int column = at.which == 0 ? depth : at.joint->across - depth;
    return numbers_per_point * (at.joint->net + column);
  }

  SideBatch side_batch(SideKind kind, const std::vector<JointSide>& sides, int count,
                       int of_each_lane) {
    SideBatch batch;
    batch.kind = kind;
    batch.leaning = sides.front().joint->leaning[sides.front().which] && kind != SideKind::uncut;
    batch.degree = sides.front().side().walk.count - 1;
    batch.raise = sides.front().joint->net_degree - batch.degree;
    batch.lanes = int(sides.size());
    batch.count = count;
    batch.memory = take_memory(sides.size(), of_each_lane);
    using At = const JointSide&;
    const int points = batch.degree + 1;
    batch.edge =
        offsets(sides, points, [&](At at, int k) { return row_point(plan_, at.side(), k, 0); });
    batch.second =
        offsets(sides, points, [&](At at, int k) { return row_point(plan_, at.side(), k, 1); });
    batch.edge_row = offsets(sides, 1, [](At at, int) { return row_of(at, 0); });
    batch.handle_row = offsets(sides, 1, [](At at, int) { return row_of(at, 1); });
    batch.fullness = offsets(sides, 1, [](At at, int) { return at.joint->fullness[at.which]; });
    batch.lean = offsets(sides, 1, [](At at, int) { return at.joint->lean[at.which]; });
    batch.cut_lo = offsets(sides, 1, [](At at, int) { return at.side().cut_lo; });
    batch.across = numbers(sides, 1, [](At at, int) { return double(at.side().walk.across); });
    batch.width = width_table(sides, kind != SideKind::uncut,
                              [](At at) -> const SideStep& { return at.side(); });
    if (kind == SideKind::uncut) {
      const auto other = [](At at) -> const SideStep& { return at.joint->side[1 - at.which]; };
      batch.free_edge = offsets(sides, 4, [&](At at, int row) {
        return numbers_per_point *
               (plan_.patches[other(at).patch].base_net + at.joint->free_edge[row / 2][row % 2]);
      });
      batch.other_across =
          numbers(sides, 1, [&](At at, int) { return double(other(at).walk.across); });
      batch.other_width = width_table(sides, true, other);
    }
    return batch;
  }

  CornerBatch corner_batch(const std::vector<const CornerStep*>& steps, int count,
                           int of_each_lane) {
    using Step = const CornerStep*;
    CornerBatch batch;
    batch.lanes = int(steps.size());
    batch.count = count;
    batch.memory = take_memory(steps.size(), of_each_lane);
    const auto three_sided = [](Step step) { return step->shape.three_sided; };
    batch.some_apex = std::any_of(steps.begin(), steps.end(), three_sided);
    batch.all_apex = std::all_of(steps.begin(), steps.end(), three_sided);
    batch.apex =
        numbers(steps, 1, [](Step step, int) { return step->shape.three_sided ? 1.0 : 0.0; });
    const auto edge_of = [](Step step, int e) -> const CornerEdgeLink& {
      return step->edges[step->shape.three_sided && e == top ? bottom : e];
    };
    // Point t of edge e, `depth` rows from the transition's end; where an edge has fewer points
    // than another its last one stands in.
    const int points = steps.front()->across + 1;
    const auto point = [&](Step step, int row, int depth) {
      const CornerEdgeLink& edge = edge_of(step, row / points);
      const JointStep& joint = plan_.joints[edge.joint];
      const int t = std::min(row % points, joint.across);
      const int column = edge.reversed ? joint.across - t : t;
      const int along = edge.end == 0 ? depth : joint.net_degree - depth;
      return numbers_per_point * (joint.net + (joint.across + 1) * along + column);
    };
    batch.end = offsets(steps, 4 * points, [&](Step step, int row) { return point(step, row, 0); });
    batch.next =
        offsets(steps, 4 * points, [&](Step step, int row) { return point(step, row, 1); });
    batch.points = offsets(steps, 4, [&](Step step, int e) {
      return plan_.joints[edge_of(step, e).joint].across + 1;
    });
    batch.degree = numbers(steps, 4, [&](Step step, int e) {
      return double(plan_.joints[edge_of(step, e).joint].net_degree);
    });
    batch.net = offsets(steps, 1, [](Step step, int) { return numbers_per_point * step->net; });
    batch.blend = offsets(steps, 1, [](Step step, int) { return numbers_per_point * step->blend; });
    batch.seam = numbers(steps, 1, [](Step step, int) { return step->shape.seam ? 1.0 : 0.0; });
    return batch;
  }

  BatchPlan& result_;
  const BodyPlan& plan_;
  int lanes_;
  int memory_ = 0;
};

BatchPlan::BatchPlan(const BodyPlan& plan, int lanes) {
  BatchPlanner planner(*this, plan, lanes);
  planner.plan_patches();
  planner.plan_seams();
  planner.plan_sides();
  planner.plan_corners();
  planner.finish();
}

}  // namespace bodyline::model
