#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/model.hpp"

/// What joins what in a body: derived from the names of the curves, and checked.
namespace bodyline::model {

/// A model that cannot be built. `key` is the dotted path of the entry at fault, as in the model
/// file, for example "patches.hood.u0" or "curves.roof__side_window.points[2]"; what() is one
/// sentence.
class ModelError : public std::runtime_error {
 public:
  ModelError(std::string key, const std::string& sentence)
      : std::runtime_error(sentence), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

enum class SideRole { free, joint, seam, mirrored };

/// What a side of a patch is part of.
struct SideLink {
  SideRole role = SideRole::free;
  int index = -1;  ///< joint or seam
  int which = 0;   ///< 0 when the patch is its a, 1 when it is its b
};

struct PatchLinks {
  int degree_u = 0, degree_v = 0;  ///< of the curves
  /// Of the patch's nets: at least those of the curves, what its family needs, and equal on both
  /// sides of a seam.
  int net_degree_u = 0, net_degree_v = 0;
  std::array<SideLink, 4> sides;
  /// Vertices at (0,0), (0,1), (1,0), (1,1). Curves that end in one vertex share that point.
  std::array<int, 4> vertices{-1, -1, -1, -1};
  bool inward = false;  ///< S_u x S_v points into the body
};

struct JointLinks {
  bool b_reversed = false;  ///< the side of b runs against the joint's direction
  bool central = false;     ///< between two central patches: its own mirror image
  std::array<int, 2> vertices{-1, -1};
  std::array<int, 2> corner{-1, -1};  ///< corner at each end, -1 at a free end
};

struct SeamLinks {
  bool b_reversed = false;
  int corner = -1;
  int corner_end = 1;  ///< end (in a's direction) at which the corner is
};

/// One edge of a corner patch: the end of a joint's transition, run from its a to its b unless
/// reversed.
struct CornerEdgeLink {
  int joint = -1;
  int end = 0;
  bool reversed = false;
};

struct CornerLinks {
  int vertex = -1;
  bool three_sided = false;
  bool seam = false;  ///< a seam ends at the corner patch's vertex (0,0)
  std::array<CornerEdgeLink, 4>
      edges;  ///< by CornerEdge: bottom, top, left, right; top unused when three-sided
  bool inward = false;
};

struct Connectivity {
  std::vector<PatchLinks> patches;
  std::vector<JointLinks> joints;
  std::vector<SeamLinks> seams;
  std::vector<CornerLinks> corners;
  std::vector<std::array<int, 2>> curve_vertices;  ///< first and last point of each curve
  int vertex_count = 0;
};

/// Derives the connectivity of a model and checks every rule a buildable body keeps; the first
/// broken rule is thrown as ModelError: known sides and curves, corners that close, equal degrees
/// along joints, each curve used as often as its role allows, mirror symmetry of central patches,
/// cuts in order and equal along seams, cuts only where a joint is, counts of shape values,
/// fullness and lean in range, a lean at every pillar foot, every number finite.
Connectivity connect(const Model& model);

/// Number of points of the curve behind a side, less one.
int side_degree(const Model& model, const Patch& patch, Side side);

/// Whether a side of a joint may lean at an end: it belongs to a patch whose seam ends at that
/// end's corner.
bool lean_allowed(const Model& model, const Connectivity& links, int joint, int side, int end);

/// Whether a strip of a patch is cut away at a side: it is a side of a joint, other than its uncut
/// one, or the mirror image of such a side.
bool side_is_cut(const Model& model, const Connectivity& links, int patch, Side side);

/// The range of fullness that a model may hold, exclusive at both ends.
inline constexpr double min_fullness = 0.0, max_fullness = 3.0;
/// The largest lean, in either direction.
inline constexpr double max_lean = 5.0;
/// The least that the two transitions at the end of a seam lean away from it, together.
inline constexpr double min_seam_lean = 0.01;

}  // namespace bodyline::model
