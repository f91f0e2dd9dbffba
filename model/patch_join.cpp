#include "model/patch_join.hpp"

#include <cmath>
#include <stdexcept>

#include "model/number_text.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

// Below this a derivative at an end does not determine a control point.
constexpr double least_constant = 1e-12;

// The sides that meet, as walks in the direction of the join.
struct JoinSides {
  Side first, second;
};
JoinSides join_sides(JoinDirection direction) {
  switch (direction) {
    case JoinDirection::u:
      return {Side::v1, Side::v0};
    case JoinDirection::uv:
      return {Side::v1, Side::u0};
    case JoinDirection::v:
      return {Side::u1, Side::u0};
  }
  return {Side::v1, Side::v0};
}

SideWalk walk_of(const FamilyPatch& patch, Side side) {
  return side_walk(side, patch.degree_u, patch.degree_v);
}

// The basis across a side, and where its shape parameters for line k of the join are.
struct Across {
  std::unique_ptr<const AnyBasis> basis;
  bool in_v;
  std::vector<ShapeRow> lines;
};
Across across_side(const FamilyPatch& patch, Side side) {
  const bool in_v = !along_v(side);
  Across across{family(patch.family, in_v ? patch.degree_v : patch.degree_u), in_v, {}};
  for (int k = 0; k < walk_of(patch, side).count; ++k)
    across.lines.push_back(in_v ? shape_row(patch, k) : ShapeRow{0, int(patch.shape_u.size())});
  return across;
}

std::span<const double> shape_at(const FamilyPatch& patch, bool in_v, const ShapeRow& row) {
  return std::span(in_v ? patch.shape_v : patch.shape_u).subspan(row.first, row.count);
}
std::span<double> shape_at(FamilyPatchBar& bar, bool in_v, const ShapeRow& row) {
  return std::span(in_v ? bar.shape_v : bar.shape_u).subspan(row.first, row.count);
}

LineJoin line_join(const FamilyPatch& first, const Across& across1, const PatchJoin& join,
                   const FamilyPatch& second, const Across& across2, int k) {
  LineJoin line{end_constants(*across1.basis, shape_at(first, across1.in_v, across1.lines[k]), 1),
                end_constants(*across2.basis, shape_at(second, across2.in_v, across2.lines[k]), 0),
                join.ratio, join.slide};
  return join.continuity == 2 ? line : first_order(line);
}

// Line k from the side inwards.
LineEnd line_end(const std::vector<Eigen::Vector3d>& points, const SideWalk& walk, int k) {
  const int at = walk.start + k * walk.step;
  return {points[at], points[at + walk.inward], points[at + 2 * walk.inward]};
}
void add_line(const LineEnd& line, const SideWalk& walk, int k,
              std::vector<Eigen::Vector3d>& points) {
  for (int depth = 0; depth < 3; ++depth)
    points[walk.start + k * walk.step + depth * walk.inward] += line[depth];
}

// The shape parameters along a side in the rows that a join determines.
std::vector<ShapeRow> rows_along(const FamilyPatch& patch, Side side, int continuity) {
  if (!along_v(side)) return {{0, int(patch.shape_u.size())}};
  if (!find_family(patch.family).shape_per_row) return {{0, int(patch.shape_v.size())}};
  std::vector<ShapeRow> rows;
  for (int depth = 0; depth <= continuity; ++depth)
    rows.push_back(shape_row(patch, side == Side::u0 ? depth : patch.degree_u - depth));
  return rows;
}

[[noreturn]] void fail(const FamilyPatch& first, const FamilyPatch& second,
                       const std::string& sentence) {
  throw std::invalid_argument("patches \"" + first.name + "\" and \"" + second.name +
                              "\" cannot be joined: " + sentence);
}

std::string place_text(const FamilyPatch& first, const FamilyPatch& second,
                       const ShapePlace& place) {
  return (place.patch == 0 ? first : second).name + (place.in_v ? ".v[" : ".u[") +
         std::to_string(place.index) + "]";
}

double shape_value(const FamilyPatch& first, const FamilyPatch& second, const ShapePlace& place) {
  const FamilyPatch& patch = place.patch == 0 ? first : second;
  return (place.in_v ? patch.shape_v : patch.shape_u)[place.index];
}

void check_constants(const FamilyPatch& first, const PatchJoin& join, const FamilyPatch& second) {
  const Across across = across_side(second, join_sides(join.direction).second);
  for (const ShapeRow& row : across.lines) {
    const EndConstants ends = end_constants(*across.basis, shape_at(second, across.in_v, row), 0);
    if (!(std::abs(ends.d) > least_constant))
      fail(first, second, "the shape of the second leaves its second row undefined");
    if (join.continuity == 2 && !(std::abs(ends.b) > least_constant))
      fail(first, second, "the shape of the second leaves its third row undefined");
  }
}

}  // namespace

const char* join_direction_name(JoinDirection direction) {
  switch (direction) {
    case JoinDirection::u:
      return "u";
    case JoinDirection::uv:
      return "uv";
    case JoinDirection::v:
      return "v";
  }
  return "";
}

JoinDirection join_direction(const std::string& name) {
  for (const JoinDirection direction : {JoinDirection::u, JoinDirection::uv, JoinDirection::v}) {
    if (name == join_direction_name(direction)) return direction;
  }
  throw std::invalid_argument("there is no join direction \"" + name + "\"; known are u, uv and v");
}

std::vector<ShapeTie> join_ties(const FamilyPatch& first, const PatchJoin& join,
                                const FamilyPatch& second) {
  const JoinSides sides = join_sides(join.direction);
  const bool first_in_v = along_v(sides.first), second_in_v = along_v(sides.second);
  const std::vector<ShapeRow> rows1 = rows_along(first, sides.first, join.continuity);
  const std::vector<ShapeRow> rows2 = rows_along(second, sides.second, join.continuity);
  std::vector<ShapeTie> ties;
  for (int k = 0; k < rows1[0].count; ++k) {
    const ShapePlace edge{0, first_in_v, rows1[0].first + k};
    for (std::size_t r = 1; r < rows1.size(); ++r)
      ties.push_back({edge, {0, first_in_v, rows1[r].first + k}});
    for (const ShapeRow& row : rows2) ties.push_back({edge, {1, second_in_v, row.first + k}});
  }
  return ties;
}

void check_join(const FamilyPatch& first, const PatchJoin& join, const FamilyPatch& second) {
  check_patch(first);
  check_patch(second);
  if (first.family != second.family) fail(first, second, "they are of different families");
  if (!find_family(first.family).joins)
    fail(first, second, "the family " + first.family + " has no join theorem");
  if (join.continuity != 1 && join.continuity != 2) fail(first, second, "continuity is 1 or 2");
  if (!(join.ratio > 0.0 && std::isfinite(join.ratio)))
    fail(first, second, "the ratio is " + number_text(join.ratio) + "; it must be positive");
  if (!std::isfinite(join.slide)) fail(first, second, "the slide is not finite");
  const JoinSides sides = join_sides(join.direction);
  const int count1 = walk_of(first, sides.first).count,
            count2 = walk_of(second, sides.second).count;
  if (count1 != count2) {
    fail(first, second,
         "their degrees along the join are " + std::to_string(count1 - 1) + " and " +
             std::to_string(count2 - 1));
  }
  for (const ShapeTie& tie : join_ties(first, join, second)) {
    const double a = shape_value(first, second, tie.a), b = shape_value(first, second, tie.b);
    if (a == b) continue;
    fail(first, second,
         "the shape parameters " + place_text(first, second, tie.a) + " and " +
             place_text(first, second, tie.b) + " must be equal, but are " + number_text(a) +
             " and " + number_text(b));
  }
  check_constants(first, join, second);
}

void join_patch(const FamilyPatch& first, const PatchJoin& join, FamilyPatch& second) {
  check_join(first, join, second);
  const JoinSides sides = join_sides(join.direction);
  const SideWalk walk1 = walk_of(first, sides.first), walk2 = walk_of(second, sides.second);
  const Across across1 = across_side(first, sides.first),
               across2 = across_side(second, sides.second);
  for (int k = 0; k < walk1.count; ++k) {
    const LineEnd line = joined_line(line_join(first, across1, join, second, across2, k),
                                     line_end(first.points, walk1, k));
    for (int depth = 0; depth <= join.continuity; ++depth)
      second.points[walk2.start + k * walk2.step + depth * walk2.inward] = line[depth];
  }
}

void join_patch_pullback(const FamilyPatch& first, const PatchJoin& join, const FamilyPatch& second,
                         FamilyPatchBar& first_bar, PatchJoinBar& join_bar,
                         FamilyPatchBar& second_bar) {
  const JoinSides sides = join_sides(join.direction);
  const SideWalk walk1 = walk_of(first, sides.first), walk2 = walk_of(second, sides.second);
  const Across across1 = across_side(first, sides.first),
               across2 = across_side(second, sides.second);
  const auto add_shape = [](const Across& across, int k, int end, const EndConstants& bar,
                            const FamilyPatch& patch, FamilyPatchBar& patch_bar) {
    const std::span<const double> shape = shape_at(patch, across.in_v, across.lines[k]);
    const std::span<double> shape_bar = shape_at(patch_bar, across.in_v, across.lines[k]);
    for (int p = 0; p < int(shape.size()); ++p) {
      const EndConstants slope = end_constants_derivative(*across.basis, shape, end, p);
      shape_bar[p] += bar.d * slope.d + bar.a * slope.a + bar.b * slope.b;
    }
  };
  for (int k = 0; k < walk1.count; ++k) {
    LineEnd line_bar{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (int depth = 0; depth <= join.continuity; ++depth) {
      Eigen::Vector3d& bar = second_bar.points[walk2.start + k * walk2.step + depth * walk2.inward];
      line_bar[depth] = bar;
      bar.setZero();
    }
    LineEnd end_bar{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    LineJoin bar;
    bar.ratio = bar.slide = 0.0;
    joined_line_pullback(line_join(first, across1, join, second, across2, k),
                         line_end(first.points, walk1, k), line_bar, end_bar, bar);
    add_line(end_bar, walk1, k, first_bar.points);
    join_bar.ratio += bar.ratio;
    join_bar.slide += bar.slide;
    add_shape(across1, k, 1, bar.first, first, first_bar);
    add_shape(across2, k, 0, bar.second, second, second_bar);
  }
}

}  // namespace bodyline::model
