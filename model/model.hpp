#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

/// The body as a user describes it: named patches that share boundary curves, and the values that
/// shape them. Only the left half and the central patches are stored; the right half is the mirror
/// image in y. Lengths are in mm. Section numbers are those of docs/mathematics.md.
namespace bodyline::model {

/// A side of a patch is an isoline of its parameters: `u0` is u = 0 and runs along v, and so on.
enum class Side { u0, u1, v0, v1 };

inline constexpr std::array<Side, 4> all_sides{Side::u0, Side::u1, Side::v0, Side::v1};

/// "u0", "u1", "v0" or "v1".
const char* side_name(Side side);

/// A boundary curve: the control points of a Bezier curve, shared by the patches that name it.
struct Curve {
  std::string name;
  std::vector<Eigen::Vector3d> points;
  std::string note;  ///< where the points come from, kept through load and save
};

/// How a side of a patch runs along a curve.
struct SideCurve {
  int curve = -1;         ///< index into Model::curves
  bool reversed = false;  ///< the side runs from the curve's last point to its first
  bool mirrored = false;  ///< the side is the curve's mirror image in y (v1 of a central patch)
};

/// A quadrilateral patch over four boundary curves, indexed by Side.
struct Patch {
  std::string name;
  bool central = false;  ///< spans the full width and is its own mirror image: v1 mirrors v0
  std::string basis = "ge-bezier";  ///< the name of its family (family.hpp)
  std::array<SideCurve, 4> sides;
  std::vector<double> shape_u;            ///< shape parameters: degree_u - 1 of GE-Bezier,
  std::vector<double> shape_v;            ///< degree_v - 1; of any family see shape_counts
  std::array<double, 2> cut_u{0.0, 1.0};  ///< kept range in u; 0 and 1 mean not cut
  std::array<double, 2> cut_v{0.0, 1.0};  ///< kept range in v
  std::string note;
};

/// One side of one patch.
struct PatchSide {
  int patch = -1;
  Side side = Side::u0;
  friend bool operator==(const PatchSide&, const PatchSide&) = default;
};

/// A curve along which two patches are cut back and joined by a transition. `a` gives the
/// direction.
struct Joint {
  std::string name;  ///< the curve's name
  PatchSide a, b;
  std::array<double, 2> fullness{1.5, 1.5};  ///< of side a and of side b, in (0, 3)
  /// lean[side][end]: sideways move of the transition's handle at that end, inwards along the
  /// joint, as a multiple of the handle's own length. Not zero only on the seam side of a pillar
  /// foot (section 8).
  std::array<std::array<double, 2>, 2> lean{};
  int continuity = 1;  ///< of the transition with both patches: 1 (normals) or 2 (curvatures too)
  std::optional<int> uncut;  ///< 0 when patch a, 1 when patch b is not cut back (section 6)
  std::string note;
};

/// A curve along which two patches meet uncut and are corrected to be G1 (section 8).
struct Seam {
  std::string name;  ///< the curve's name
  PatchSide a, b;
};

/// A point where three or four joints end and a corner patch closes the body.
struct Corner {
  std::string name;
  std::vector<int> patches;  ///< in cyclic order around the point
  int apex = -1;  ///< three joints only: the patch at whose kept corner the corner patch closes
};

/// The curves that bound a wheel arch; the wheelbase is the distance between the arches' centres.
struct WheelArch {
  std::vector<int> curves;
};

/// A whole body. `connect` checks it and derives what joins what.
struct Model {
  std::string name;
  std::string note;
  std::string units = "mm";
  std::vector<Curve> curves;
  std::vector<Patch> patches;
  std::vector<Joint> joints;
  std::vector<Seam> seams;
  std::vector<Corner> corners;
  WheelArch front_arch, rear_arch;
};

}  // namespace bodyline::model
