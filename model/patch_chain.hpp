#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/bezier_form.hpp"
#include "model/family_patch.hpp"
#include "model/patch_join.hpp"

namespace bodyline::model {

/// Patches of one family, each joined to the one before it.
struct PatchChain {
  std::string name;
  std::vector<FamilyPatch> patches;
  std::vector<PatchJoin> joins;  ///< joins[k] between patches k and k + 1
};

/// Writes the rows that the joins determine, patch after patch, so that every join holds exactly.
/// Throws std::invalid_argument when the counts do not fit, and as join_patch.
void propagate(PatchChain& chain);

/// Where each number of a chain lies in one flat vector: points, shape parameters, joins.
class ChainLayout {
 public:
  explicit ChainLayout(const PatchChain& chain);
  int size() const { return size_; }
  /// First of the three coordinates of a control point.
  int point(int patch, int index) const { return patches_[patch].points + 3 * index; }
  int shape(int patch, bool in_v, int index) const {
    return (in_v ? patches_[patch].shape_v : patches_[patch].shape_u) + index;
  }
  int ratio(int join) const { return joins_ + 2 * join; }
  int slide(int join) const { return joins_ + 2 * join + 1; }

 private:
  struct Offsets {
    int points, shape_u, shape_v;
  };
  std::vector<Offsets> patches_;
  int joins_ = 0, size_ = 0;
};

Eigen::VectorXd to_numbers(const PatchChain& chain, const ChainLayout& layout);
void set_numbers(PatchChain& chain, const ChainLayout& layout, const Eigen::VectorXd& numbers);

/// Adjoints of all numbers of a propagated chain from those of its patches (consumed): what the
/// joins determined passes its adjoint on, patch after patch, and has none of its own.
Eigen::VectorXd propagate_pullback(const PatchChain& chain, const ChainLayout& layout,
                                   std::vector<FamilyPatchBar>& bars);

}  // namespace bodyline::model
