#pragma once

#include <memory>
#include <vector>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// Most Gauss nodes per direction.
inline constexpr int max_nodes = 64;

/// Gauss-Legendre nodes (rising) and weights on [lo, hi], to full accuracy.
struct GaussRule {
  std::vector<double> nodes, weights;
};
GaussRule gauss_rule(int nodes, double lo, double hi);
/// The Gauss-Lobatto rule, two or more nodes: both ends are nodes; exact to degree 2 nodes - 3.
GaussRule lobatto_rule(int nodes, double lo, double hi);

/// What part of a face is integrated: all of it, or the half of a central face on the left
/// (parameter in [0, 1/2]).
enum class Range { whole, half_u, half_v };

/// The part over which energies are summed: all of a side face, the left half of a central one.
Range summed_range(const Face& face);
Range summed_range(const Surface& surface);

/// Owns the tables behind a FaceRule: Bernstein polynomials at the nodes, and the jets of the
/// Gregory function (section 8) where `with_blend` asks for them. Can be moved, not copied; a rule
/// taken from it stays valid as long as the tables live.
class FaceTables {
 public:
  using MakeRule = GaussRule (*)(int nodes, double lo, double hi);

  /// Degrees 1 to 12; `nodes` per direction, a multiple of 8 up to 64. Throws std::invalid_argument
  /// otherwise.
  FaceTables(int degree_u, int degree_v, int nodes, Range range, bool with_blend,
             MakeRule make_rule = gauss_rule);
  const FaceRule& rule() const { return rule_; }
  const GaussRule& rule_u() const { return gauss_u_; }
  const GaussRule& rule_v() const { return gauss_v_; }

 private:
  struct Deleter {
    void operator()(double* p) const;
  };
  GaussRule gauss_u_, gauss_v_;
  std::unique_ptr<double[], Deleter> data_;
  FaceRule rule_;
};

}  // namespace bodyline::model
