#include "model/bernstein.hpp"

namespace bodyline::model {
namespace {

using Row = std::array<double, max_degree + 1>;

Row values(int degree, double t) {
  Row b{};
  b[0] = 1.0;
  for (int n = 1; n <= degree; ++n) {
    double carried = 0.0;
    for (int i = 0; i < n; ++i) {
      const double kept = b[i];
      b[i] = carried + (1.0 - t) * kept;
      carried = t * kept;
    }
    b[n] = carried;
  }
  return b;
}

}  // namespace

BernsteinJet bernstein(int degree, double t) {
  BernsteinJet jet{};
  double factor = 1.0;
  for (int k = 0; k <= 3; ++k) {
    if (k > degree) break;
    // The k-th derivative is degree!/(degree-k)! times the k-th backward difference of degree - k.
    Row row = values(degree - k, t);
    for (int step = 1; step <= k; ++step) {
      for (int i = degree - k + step; i >= 0; --i) {
        const double left = i > 0 ? row[i - 1] : 0.0;
        const double right = i < degree - k + step ? row[i] : 0.0;
        row[i] = left - right;
      }
    }
    for (int i = 0; i <= degree; ++i) jet.d[k][i] = factor * row[i];
    factor *= degree - k;
  }
  return jet;
}

}  // namespace bodyline::model
