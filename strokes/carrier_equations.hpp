#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "strokes/carrier.hpp"

namespace bodyline::strokes {

/// A point that a carrier shall pass over a place.
struct CarrierSample {
  Eigen::Vector2d place;  ///< in the domain
  Eigen::Vector3d point;  ///< mm
  double weight = 1.0;    ///< length of the stroke that it stands for, in the domain
};

/// What the energy of a fit is of.
enum class Fair {
  surface,      ///< F = B + G: the base gives way to a fairer surface
  displacement  ///< F = G: the base is left alone where samples do not call for more
};

/// Normal equations of the displacement G of a base B over one basis: the least of
///   sum w |B + G - P|^2 + fairness * integral of (a F_ss^2 + 2 F_st^2 + F_tt^2 / a),
/// where F is B + G or G, and a is the squared ratio of the domain's extents in t and in s in
/// space.
class CarrierEquations {
 public:
  CarrierEquations(SurfaceFunction base, CarrierBasis basis, Fair fair = Fair::surface);

  /// Takes the samples in place of those before.
  void set_samples(const std::vector<CarrierSample>& samples);

  /// None when the equations cannot be solved.
  std::optional<Carrier> solve(double fairness) const;

 private:
  /// A symmetric matrix of the basis: the entries of a function and those up to three rows and
  /// columns of the grid behind it.
  struct Stencil {
    static constexpr int reach = 3, width = 2 * reach + 1;
    explicit Stencil(int functions) : entries(Eigen::MatrixXd::Zero(width * width, functions)) {}
    void add(const CarrierBasis& basis, const std::array<int, CarrierBasis::at_once>& index,
             const Eigen::Matrix<double, CarrierBasis::at_once, CarrierBasis::at_once>& block);
    Eigen::MatrixXd entries;
  };

  void add_energy(Fair fair);

  SurfaceFunction base_;
  CarrierBasis basis_;
  Stencil energy_, data_;
  Eigen::MatrixX3d energy_right_, data_right_;
};

}  // namespace bodyline::strokes
