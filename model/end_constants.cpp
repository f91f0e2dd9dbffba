#include "model/end_constants.hpp"

namespace bodyline::model {
namespace {

EndConstants from_jet(const BasisJet& jet, int degree, int end) {
  if (end == 0) return {jet.d[1][1], jet.d[2][0], jet.d[2][2]};
  return {-jet.d[1][degree - 1], jet.d[2][degree], jet.d[2][degree - 2]};
}

}  // namespace

EndConstants end_constants(const AnyBasis& basis, std::span<const double> shape, int end) {
  return from_jet(basis.evaluate(end, shape), basis.degree(), end);
}

EndConstants end_constants_derivative(const AnyBasis& basis, std::span<const double> shape, int end,
                                      int k) {
  return from_jet(basis.shape_derivative(end, shape, k), basis.degree(), end);
}

}  // namespace bodyline::model
