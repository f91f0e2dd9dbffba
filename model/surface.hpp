#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace bodyline::model {

/// What a face of the body is.
enum class FaceKind { patch, transition, corner };

/// How far the body is built: whole patches (G0), patches cut back, or everything closed (G1).
enum class Stage { base, kept, body };

const char* stage_name(Stage stage);

/// One face: a Bezier patch, with a Gregory term where three different tangent fields meet (section
/// 8).
///   S(u,v) = sum_ij B_i(u) B_j(v) net[i][j] + blend * g(u,v),
///   g = u (1-u)^2 v (1-v)^2 (u^2 - v^2) / (u^2 + v^2), and 0 at the corner (0,0).
struct Surface {
  std::string name;  ///< patch, joint or corner; mirror images end in ".right"
  FaceKind kind = FaceKind::patch;
  int degree_u = 0, degree_v = 0;
  std::vector<Eigen::Vector3d> net;      ///< (degree_u + 1) x (degree_v + 1) points, v fastest; mm
  std::optional<Eigen::Vector3d> blend;  ///< mm; absent on a polynomial face
  bool central = false;                  ///< its own mirror image
  bool inward = false;                   ///< S_u x S_v points into the body

  const Eigen::Vector3d& point(int i, int j) const { return net[i * (degree_v + 1) + j]; }
  Eigen::Vector3d& point(int i, int j) { return net[i * (degree_v + 1) + j]; }
};

/// The jet of a surface at one parameter: all partial derivatives to third order.
/// `d[jet_index(a, b)]` is the derivative a times in u and b times in v.
struct SurfaceJet {
  std::array<Eigen::Vector3d, 10> d;
};

/// Position of the (a, b) derivative in a jet, a + b <= 3: S, Su, Sv, Suu, Suv, Svv, Suuu, Suuv,
/// Suvv, Svvv.
constexpr int jet_index(int a, int b) { return (a + b) * (a + b + 1) / 2 + b; }

/// The jet at (u, v) in [0,1]^2, derivatives up to `order` (0 to 3); higher ones are left zero.
/// The Gregory term is not differentiable twice at its corner; there its second and third
/// derivatives are zero.
SurfaceJet jet(const Surface& surface, double u, double v, int order = 2);

/// Unit normal, pointing out of the body. At a degenerate corner it is the limit along the
/// diagonal.
Eigen::Vector3d outward_normal(const Surface& surface, double u, double v);

/// Mean and Gauss curvature from a jet, 1/mm and 1/mm^2; positive mean for a sphere seen from
/// outside when `inward` says on which side outside is.
struct Curvature {
  double mean = 0.0;
  double gauss = 0.0;
};
Curvature curvature(const SurfaceJet& jet, bool inward);

/// The mirror image in y, named with the suffix ".right".
Surface mirror_image(const Surface& surface);

}  // namespace bodyline::model
