#pragma once

#include <vector>

#include "model/bezier_form.hpp"
#include "model/family_patch.hpp"
#include "model/line_join.hpp"

/// Joining a patch to another of its family with one or two derivatives: Theorems 1-3 of Hu et al.
/// 2017 for Bezier-like patches, Theorems 5-7 of Li et al. 2020 for H-Bezier ones
/// (docs/families.md, section 4).
namespace bodyline::model {

/// Which sides meet, in the words of the papers.
enum class JoinDirection {
  u,   ///< S1(u, 1) and S2(u, 0): both run along u (Theorems 1 and 5)
  uv,  ///< S1(u, 1) and S2(0, v), v = u: along u, then along v (Theorems 2 and 6)
  v,   ///< S1(1, v) and S2(0, v): both run along v (Theorems 3 and 7)
};

/// "u", "uv" or "v"; join_direction throws std::invalid_argument listing the names.
const char* join_direction_name(JoinDirection direction);
JoinDirection join_direction(const std::string& name);

struct PatchJoin {
  JoinDirection direction = JoinDirection::u;
  int continuity = 1;  ///< 1 or 2: G1 or G2
  double ratio = 1.0;  ///< positive: derivative across of the second patch over that of the first;
                       ///< 1 / f of the Bezier-like theorems, gamma of the H-Bezier ones
  double slide = 0.0;  ///< G2 only: S2'' = ratio^2 S1'' + slide S1'
};

/// A shape parameter of one of the two patches of a join.
struct ShapePlace {
  int patch = 0;      ///< 0: the first, 1: the second
  bool in_v = false;  ///< in shape_v, else in shape_u
  int index = 0;
};

/// Two shape parameters that a join needs to be equal.
struct ShapeTie {
  ShapePlace a, b;
};

/// What a join ties: the shape parameters along it; of Bezier-like patches whose rows run along it,
/// those of as many rows as it determines, on both sides.
std::vector<ShapeTie> join_ties(const FamilyPatch& first, const PatchJoin& join,
                                const FamilyPatch& second);

/// Throws std::invalid_argument, with a sentence, when two patches cannot be joined: families or
/// degrees along the join differ, tied shape parameters differ, the ratio is not positive, or the
/// second patch's shape leaves a row undefined (degree 2 with a parameter of -1, or 1 with G2).
void check_join(const FamilyPatch& first, const PatchJoin& join, const FamilyPatch& second);

/// Writes the rows of the second patch that the join determines: two with G1, three with G2; the
/// others are free. Throws as check_join.
void join_patch(const FamilyPatch& first, const PatchJoin& join, FamilyPatch& second);

/// Adjoints of the numbers of a join.
struct PatchJoinBar {
  double ratio = 0.0, slide = 0.0;
};

/// Moves the adjoints of the rows that join_patch wrote to what it read.
void join_patch_pullback(const FamilyPatch& first, const PatchJoin& join, const FamilyPatch& second,
                         FamilyPatchBar& first_bar, PatchJoinBar& join_bar,
                         FamilyPatchBar& second_bar);

}  // namespace bodyline::model
