#include "model/chain_faces.hpp"

#include <algorithm>

#include "model/bezier_pieces.hpp"

namespace bodyline::model {

std::vector<Surface> chain_faces(const PatchChain& chain, double tolerance_mm) {
  double size_mm = tolerance_mm;
  for (const FamilyPatch& patch : chain.patches)
    size_mm = std::max(size_mm, control_size(patch.points));
  std::vector<Surface> faces;
  bool inward = false;
  for (std::size_t k = 0; k < chain.patches.size(); ++k) {
    // Round a corner of the parameters S_u x S_v changes sides.
    if (k > 0 && chain.joins[k - 1].direction == JoinDirection::uv) inward = !inward;
    for (Surface& piece : bezier_pieces(chain.patches[k], tolerance_mm, size_mm)) {
      piece.inward = inward;
      faces.push_back(std::move(piece));
    }
  }
  return faces;
}

}  // namespace bodyline::model
