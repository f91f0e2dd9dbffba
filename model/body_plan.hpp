#pragma once

#include <string>
#include <vector>

#include "model/connect.hpp"
#include "model/corner_net.hpp"
#include "model/parameters.hpp"
#include "model/side_geometry.hpp"
#include "model/surface.hpp"

/// The body as a list of steps over flat arrays: which parameters feed which net. Made once per
/// model, shared by every evaluation.
namespace bodyline::model {

/// One patch: base net, cut, kept net. Net offsets count points.
struct PatchStep {
  int degree_u = 0, degree_v = 0;              ///< of its nets
  int curve_degree_u = 0, curve_degree_v = 0;  ///< of its curves; lower in some families
  std::string family;
  /// Built by itself (shaped_patch.hpp): of another family than GE-Bezier, or of a higher degree
  /// than its curves.
  bool shaped = false;
  int base_net = 0, kept_net = 0;
  int shape_u = 0, shape_v = 0, cut = 0;  ///< parameters
  /// Boundary points: parameter of the point and whether it is mirrored, for each index on the
  /// boundary of a net of the curves' degrees.
  struct BoundaryPoint {
    int net_index = 0;
    int parameter = 0;
    bool mirrored = false;
  };
  std::vector<BoundaryPoint> boundary;
};

/// A side of a kept net, walked in the direction of its joint or seam.
struct SideStep {
  int patch = -1;
  SideWalk walk;
  int cut_at = 0;         ///< parameter that says where the strip along this side is cut off
  bool at_upper = false;  ///< it is the upper end of the kept range: the strip is 1 - value wide
  int cut_lo = 0;  ///< parameter of the lower end of the kept range across this side, of which
                   ///< cut_at is one end; the upper end is the next parameter
};

struct SeamStep {
  int degree = 0;
  SideStep a, b;  ///< walked from the seam's free end to the pillar foot
};

struct JointStep {
  int net_degree = 0;  ///< of the transition along the joint: the higher of the two patches', that
                       ///< of an uncut one counted as one more
  int continuity = 1;  ///< with both kept patches: 1 or 2
  int across = 3;      ///< degree of the transition across the joint: 5 with continuity 2
  int net = 0;         ///< offset; (net_degree + 1) x (across + 1) points, from a to b fastest
  SideStep side[2];
  int fullness[2] = {0, 0};  ///< parameters
  int lean[2] = {0, 0};      ///< parameter of end 0; end 1 follows
  bool leaning[2] = {false, false};
  int uncut = -1;
  /// Uncut side only: base-net indices of the other patch's free edge at both ends of the joint: at
  /// the joint, next.
  int free_edge[2][2] = {{0, 0}, {0, 0}};
};

struct CornerStep {
  CornerShape shape;
  int across = 3;  ///< the highest degree across of the joints that end here
  int net = 0;     ///< offset of corner_points(across) points
  int blend = 0;   ///< offset of the Gregory coefficient in the same arena
  std::array<CornerEdgeLink, 4> edges;
};

/// One face that a stage consists of.
struct Face {
  std::string name;
  FaceKind kind = FaceKind::patch;
  int degree_u = 0, degree_v = 0;
  int net = 0;
  int blend = -1;  ///< offset, -1 on a polynomial face
  bool central = false;
  bool central_along_u =
      false;  ///< the mirror acts on u instead of v (transitions between central patches)
  bool inward = false;
};

struct BodyPlan {
  Connectivity links;
  ParameterLayout layout;
  std::vector<PatchStep> patches;
  std::vector<SeamStep> seams;
  std::vector<JointStep> joints;
  std::vector<CornerStep> corners;
  int point_count =
      0;  ///< points in the arena of all nets: base nets, kept nets, transitions, corners
  int kept_begin = 0;                                    ///< first point of the kept nets
  std::vector<Face> base_faces, kept_faces, body_faces;  ///< left half and central

  const std::vector<Face>& faces(Stage stage) const;
};

/// Plans the construction of a model. Throws ModelError as `connect` does.
BodyPlan plan_body(const Model& model);

}  // namespace bodyline::model
