#pragma once

/// The inner loops over the Gauss nodes of one face, compiled once for each instruction set and
/// chosen at run time. They see plain arrays; face_rule.hpp fills the tables.
namespace bodyline::model {

/// Tables of one face's quadrature: Bernstein values and derivatives at the nodes of a tensor Gauss
/// rule. Shared by all faces of the same degrees and range; nothing here depends on the net.
struct FaceRule {
  int degree_u = 0, degree_v = 0;
  int nodes = 0;  ///< per direction, a multiple of 8
  /// basis_u[(order * (degree_u + 1) + i) * nodes + k]: derivative `order` (0..3) of B_i at node k;
  /// 64-byte aligned.
  const double* basis_u = nullptr;
  const double* basis_v = nullptr;
  const double* weights_u = nullptr;  ///< nodes; they sum to the length of the integrated range
  const double* weights_v = nullptr;
  /// Jets of the Gregory function g at the nodes, or null: blend[(q * nodes + kv) * nodes + ku], q
  /// = jet_index.
  const double* blend = nullptr;
};

/// Parameters of the fold barrier: nodes whose normal makes a cosine c below `cosine` (above -1)
/// with the face's mean normal, the direction of its vector area over the integrated range, pay
/// ((cosine - c) / (1 + cosine))^3; the mean over the nodes is the term's value.
struct FoldOptions {
  double cosine = 0.25;
};

/// Points and the parameters of their nearest points on one face, coordinate by coordinate. All
/// arrays have room for `count` rounded up to a multiple of 8, with parameters in [0, 1] there too.
struct FootPointArrays {
  int count = 0;
  const double *x = nullptr, *y = nullptr, *z = nullptr;  ///< the points
  double *u = nullptr, *v = nullptr;                      ///< where to start; where it ended
  double* foot[3] = {};                                   ///< the nearest points found
  double* normal[3] = {};  ///< unit normals there, along Su x Sv; 0 where there is none
};

/// How strongly the points of a scan pull at a face. A point lies at d from its foot, off = d . n
/// along the outward unit normal n there and t = d - off n along the surface; c is the cosine
/// between n and the scan's normal, 0 where it is negative, 1 where the scan has none; and
/// g(x, r) = 1 / (1 + x / r^2)^2, the weight of Geman and McClure. Then
///
///   W = c^2 g(|d|^2, normal_reach) n n'                                   within the face,
///   W = c^2 g(off^2, normal_reach) g(t^2, rim_reach) (n n' + t t' / t^2)  at a rim,
///
/// and W = 0 at the ends of rims, and where t is not 0 at a rim but c is below least_rim_cosine.
/// Beside an inner edge the whole of d counts: there the face beyond the edge has the point.
struct PullRule {
  const double* scan_normal[3] = {};  ///< at the points; null where the scan has none
  bool inward = false;                ///< whether Su x Sv of the face points into the body
  bool rims[4] = {};                  ///< which of the sides u = 0, u = 1, v = 0, v = 1 are rims
  double normal_reach = 0.0, rim_reach = 0.0;  ///< mm
  double least_rim_cosine = 0.0;
};

/// Points on a face and where they should be, coordinate by coordinate, with room as
/// FootPointArrays have: each adds (S(u,v) - target)' W (S(u,v) - target) to a sum of squares.
struct PullArrays {
  int count = 0;
  const double *u = nullptr, *v = nullptr;
  double* weight[6] = {};           ///< W: xx, xy, xz, yy, yz, zz; zero beyond `count`
  double* weighted_target[3] = {};  ///< W target; likewise
};

/// What the moments do not hold of pulls.
struct PullSums {
  double constant = 0.0;  ///< sum of target' W target
  double weight = 0.0;    ///< sum of the traces of W
};

/// Numbers for each entry of W in a row of second moments: 2 degree_v + 1, rounded up to a multiple
/// of 8.
constexpr int moment_width(int degree_v) { return (2 * degree_v + 8) / 8 * 8; }

/// Numbers between rows of second moments.
constexpr int moment_stride(int degree_v) { return 6 * moment_width(degree_v); }

/// Value kernels: `net` has (degree_u+1)(degree_v+1)*3 doubles, xyz fastest, then v; `blend` 3
/// doubles, read only where rule.blend is set. Pullback kernels return the same value and add seed
/// * d value / d net to `net_bar` (and to `blend_bar`). None allocates; all are safe to call from
/// several threads at once.
struct Kernels {
  const char* name = "";
  using Value = double (*)(const FaceRule&, const double* net, const double* blend);
  using Pullback = double (*)(const FaceRule&, const double* net, const double* blend, double seed,
                              double* net_bar, double* blend_bar);
  Value area = nullptr;       ///< integral of dA, mm^2
  Value bending = nullptr;    ///< integral of (k1^2 + k2^2) dA
  Value variation = nullptr;  ///< integral of |grad_S H|^2 dA, 1/mm^2
  Pullback area_pullback = nullptr;
  Pullback bending_pullback = nullptr;
  Pullback variation_pullback = nullptr;
  double (*fold)(const FaceRule&, const double* net, const double* blend,
                 const FoldOptions&) = nullptr;
  double (*fold_pullback)(const FaceRule&, const double* net, const double* blend,
                          const FoldOptions&, double seed, double* net_bar,
                          double* blend_bar) = nullptr;
  /// Jets at all nodes: out[((q * 3 + c) * nodes + kv) * nodes + ku], q = jet_index, c = x, y, z;
  /// order 1, 2 or 3.
  void (*jets)(const FaceRule&, const double* net, const double* blend, int order,
               double* out) = nullptr;
  /// Mean and Gauss curvature at all nodes, each nodes*nodes doubles, [kv][ku]. The mean curvature
  /// is positive where the face bends towards Su x Sv.
  void (*curvature)(const FaceRule&, const double* net, const double* blend, double* mean,
                    double* gauss) = nullptr;
  /// `steps` steps of Newton's method towards the nearest points of a face, degrees up to 12, from
  /// the given parameters; `blend` is null on a polynomial face.
  void (*foot_points)(int degree_u, int degree_v, const double* net, const double* blend, int steps,
                      const FootPointArrays&) = nullptr;
  /// The pulls at foot points, as PullRule says; `distance` gets how far the
  /// points are. `out` has the count of the points and as much room.
  PullSums (*pulls)(const FootPointArrays&, const PullRule&, const PullArrays& out,
                    double* distance) = nullptr;
  /// Adds up sum B_a(u) B_b(v) W over the points, B of the doubled degrees, into second[a *
  /// moment_stride(degree_v) + entry * moment_width(degree_v) + b], and sum B_i(u) B_j(v) W target
  /// into first[3 (i (degree_v + 1) + j) + c]. Degrees up to 12.
  void (*add_moments)(int degree_u, int degree_v, const PullArrays&, double* second,
                      double* first) = nullptr;
};

/// Instruction sets a binary may carry.
enum class Isa { baseline, avx2, avx512 };

/// Whether this processor (and this build) can run the kernels of `isa`.
bool isa_available(Isa isa);

/// The best available set; the environment variable BODYLINE_ISA=baseline|avx2|avx512 overrides it.
Isa best_isa();

/// Kernels of one instruction set. Throws std::invalid_argument when it is not available.
const Kernels& kernels(Isa isa);

}  // namespace bodyline::model
