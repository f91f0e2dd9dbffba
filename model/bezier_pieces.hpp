#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/family.hpp"
#include "model/family_patch.hpp"
#include "model/surface.hpp"

/// Curves and patches of any family as Bezier pieces within a tolerance, for export, pictures and
/// measures. Polynomial families give one exact piece. The others are interpolated on spans that
/// are halved until they agree, with value and two derivatives at both ends of each span: so pieces
/// join with two derivatives, and joints of patches stay what they are when both sides have the
/// same breaks.
namespace bodyline::model {

/// Parameters 0 = t_0 < t_1 < ... = 1 between which a basis is replaced by polynomials such that
/// sum_i |error of G_i| <= tolerance, a fraction of the distances between control points.
std::vector<double> bezier_breaks(const AnyBasis& basis, std::span<const double> shape,
                                  double tolerance);

/// Bezier forms of all functions on each span, as the rows of a matrix; one for a polynomial
/// family. `tolerance` as above.
std::vector<FormMatrix> bezier_spans(const Family& family, const AnyBasis& basis,
                                     std::span<const double> shape, double tolerance);

/// The patch as one face or several, named NAME or NAME.1, NAME.2, ... in the order of u, then v.
/// `tolerance_mm` bounds the distance at equal parameters; patches that share the shape parameters
/// along a joint and `size_mm`, a bound on the distance of any two control points, share the breaks
/// there. Throws as check_patch, and std::invalid_argument unless both lengths are positive.
std::vector<Surface> bezier_pieces(const FamilyPatch& patch, double tolerance_mm, double size_mm);

/// The largest distance of two control points' coordinates, times sqrt(3).
double control_size(const std::vector<Eigen::Vector3d>& points);

}  // namespace bodyline::model
