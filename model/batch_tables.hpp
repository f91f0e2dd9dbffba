#pragma once

/// The construction of a body as batches of equal steps: tables of where each step reads and
/// writes. Plain pointers, for code that is compiled once per instruction set; batch_plan.hpp makes
/// them.
///
/// A batch has `lanes` lanes, of which the first `count` hold a step each; the others repeat the
/// last step, and their adjoints are dropped. `memory` is where what it keeps for the pullback
/// begins, in numbers. A table's comment gives its indices, the lane always last. Entries are
/// positions in the parameters or in the array of all nets, in numbers, not points; of a point,
/// that of its x.
namespace bodyline::model {

/// Patches of equal degrees: base net, cut, kept net.
struct PatchBatch {
  int lanes = 0, count = 0, memory = 0;
  int degree_u = 0, degree_v = 0;
  int boundary_count = 0;
  const int* boundary_net = nullptr;           ///< [point]: index in the net, the same in all lanes
  const int* boundary = nullptr;               ///< [point][lane]: parameter
  const double* boundary_sign = nullptr;       ///< [point][lane]: of y, -1 where mirrored
  const int *base = nullptr, *kept = nullptr;  ///< [lane]: nets
  const int *shape_u = nullptr, *shape_v = nullptr, *cut = nullptr;  ///< [lane]: first parameter
};

/// Seams of equal degree that share no points.
struct SeamBatch {
  int lanes = 0, count = 0, memory = 0;
  int degree = 0;
  const int* edge = nullptr;  ///< [point][lane]: of the kept net of a
  const int *second_a = nullptr, *second_b = nullptr;
};

/// The width cut away from a side: offset + factor * parameter.
struct WidthTable {
  const int* parameter = nullptr;  ///< [lane]
  const double *offset = nullptr, *factor = nullptr;
};

enum class SideKind {
  plain,   ///< of the transition's own degree along the joint
  raised,  ///< of a lower degree: the other side is uncut or of a higher degree
  uncut
};

/// Sides of joints: two rows of a transition each.
struct SideBatch {
  int lanes = 0, count = 0, memory = 0;
  SideKind kind = SideKind::plain;
  bool leaning = false;
  int degree = 0;  ///< of the kept edge, along the joint
  int raise = 0;   ///< how much higher the transition's degree is; at least 1 unless plain
  const int *edge = nullptr, *second = nullptr;  ///< [point][lane]: rows of the kept net
  const int *edge_row = nullptr,
            *handle_row = nullptr;  ///< [lane]: first points of the transition's rows
  const int *fullness = nullptr, *lean = nullptr, *cut_lo = nullptr;  ///< [lane]
  const double* across = nullptr;  ///< [lane]: degree across the side
  WidthTable width;                ///< 1 at an uncut side
  /// Sides of joints with continuity 2 only: rows of the kept net, and the transition's third row.
  const int *third = nullptr, *bend_row = nullptr;
  /// Uncut sides only: the free edge of the other patch's base net, [end][at the joint,
  /// next][lane].
  const int* free_edge = nullptr;
  const double* other_across = nullptr;
  WidthTable other_width;
};

/// Numbers between neighbouring points of a transition's row; of a quintic transition's.
inline constexpr int transition_row_step = 12, bend_row_step = 18;

/// Corner patches.
struct CornerBatch {
  int lanes = 0, count = 0, memory = 0;
  bool some_apex = false, all_apex = false;  ///< lanes that are three-sided
  const double* apex = nullptr;              ///< [lane]: 1 in those, else 0
  /// Where a corner has no top edge, its bottom edge stands in for it.
  const int *end = nullptr,
            *next = nullptr;  ///< [edge][point][lane]: end row of the transition, the row before it
  const double* degree = nullptr;  ///< [edge][lane]: of the transition along its joint
  /// Beside joints with continuity 2 only: [edge], 4 or 6; tables above then have 6 points an edge.
  const int* points = nullptr;
  const int *net = nullptr, *blend = nullptr;
  const double* seam = nullptr;  ///< [lane]: 1 where a seam ends, else 0
};

struct BatchTables {
  int number_count = 0;  ///< numbers in the array of all nets
  int memory = 0;        ///< numbers that all batches keep
  int patch_count = 0, seam_count = 0, side_count = 0, corner_count = 0;
  int bend_side_count = 0, bend_corner_count = 0;
  const PatchBatch* patches = nullptr;
  const SeamBatch* seams = nullptr;
  const SideBatch* sides = nullptr;
  const CornerBatch* corners = nullptr;
  /// Sides of joints with continuity 2, and the corners that touch such a joint: one lane each,
  /// built after all others (batch_bends.hpp).
  const SideBatch* bend_sides = nullptr;
  const CornerBatch* bend_corners = nullptr;
};

/// The last stage to build, as `Stage`.
enum class LastStage { base, kept, body };

}  // namespace bodyline::model
