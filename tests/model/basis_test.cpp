#include "model/basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bodyline::model {
namespace {

// Sums of at most ten products of numbers near 1 to 100.
constexpr double rounding = 1e-12;
// Central differences of smooth functions with step 1e-5: h^2 truncation and eps / h rounding.
constexpr double difference_step = 1e-5;
constexpr double difference_tolerance = 2e-5;

std::vector<double> random_shape(const GeBezierBasis& basis, std::mt19937& random) {
  std::uniform_real_distribution<double> in(0.0, 1.0);
  std::vector<double> shape;
  for (int k = 0; k < basis.shape_count(); ++k) {
    const ShapeRange range = basis.shape_range(k);
    shape.push_back(range.lower + in(random) * (range.upper - range.lower));
  }
  return shape;
}

class GeBezier : public testing::TestWithParam<int> {
 protected:
  GeBezierBasis basis{GetParam()};
  std::mt19937 random{unsigned(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(AllDegrees, GeBezier, testing::Range(2, 10));

TEST_P(GeBezier, SumsToOneAndItsDerivativesToZero) {
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<double> shape = random_shape(basis, random);
    const BasisJet jet = basis.evaluate(trial / 19.0, shape);
    for (int order = 0; order < 4; ++order) {
      double sum = 0.0;
      for (int i = 0; i <= basis.degree(); ++i) sum += jet.d[order][i];
      EXPECT_NEAR(sum, order == 0 ? 1.0 : 0.0, rounding * 1e3);
    }
  }
}

TEST_P(GeBezier, InterpolatesItsEnds) {
  const std::vector<double> shape = random_shape(basis, random);
  for (int i = 0; i <= basis.degree(); ++i) {
    EXPECT_NEAR(basis.evaluate(0.0, shape).d[0][i], i == 0 ? 1.0 : 0.0, rounding);
    EXPECT_NEAR(basis.evaluate(1.0, shape).d[0][i], i == basis.degree() ? 1.0 : 0.0, rounding);
  }
}

TEST_P(GeBezier, IsBernsteinAtItsNeutralShape) {
  std::vector<double> shape;
  for (int k = 0; k < basis.shape_count(); ++k) shape.push_back(basis.neutral_shape(k));
  EXPECT_EQ(basis.conversion(shape),
            Eigen::MatrixXd::Identity(basis.degree() + 1, basis.degree() + 1));
}

// The printed formulas of the basis, case by case (docs/mathematics.md, section 2).
double printed_function(int n, int i, double t, const std::vector<double>& l) {
  const auto shape = [&](int k) { return k < 0 || k > n - 2 ? 0.0 : l[k]; };
  const double s = 1.0 - t;
  const auto power = [](double x, int k) { return std::pow(x, k); };
  const bool even = n % 2 == 0;
  const int h = (n - 1) / 2;
  if (even && 2 * i == n) return 2.0 * shape(i - 1) * power(s, i) * power(t, i);
  if (!even && (i == h || i == h + 1)) {
    return (binomial(n - 1, h) + shape(i - 1)) * power(s, n - i) * power(t, i);
  }
  if (2 * i < n) {
    return (binomial(n - 1, i) - shape(i) * t + shape(i - 1) * s) * power(s, n - 1 - i) *
           power(t, i);
  }
  return (binomial(n - 1, i - 1) + shape(i - 1) * t - shape(i - 2) * s) * power(s, n - i) *
         power(t, i - 1);
}

TEST_P(GeBezier, AgreesWithThePrintedFormulas) {
  const int n = basis.degree();
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<double> shape = random_shape(basis, random);
    const double t = (trial + 0.5) / 10.0;
    const BasisJet jet = basis.evaluate(t, shape);
    for (int i = 0; i <= n; ++i) {
      EXPECT_NEAR(jet.d[0][i], printed_function(n, i, t, shape), rounding * 100)
          << "function " << i;
    }
  }
}

TEST_P(GeBezier, IsPositiveInsideItsShapeRange) {
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<double> shape = random_shape(basis, random);
    for (int k = 0; k <= 40; ++k) {
      const BasisJet jet = basis.evaluate(k / 40.0, shape);
      for (int i = 0; i <= basis.degree(); ++i) EXPECT_GE(jet.d[0][i], -rounding);
    }
  }
}

TEST_P(GeBezier, IsNegativeSomewhereJustOutsideItsShapeRange) {
  std::vector<double> neutral;
  for (int k = 0; k < basis.shape_count(); ++k) neutral.push_back(basis.neutral_shape(k));
  for (int k = 0; k < basis.shape_count(); ++k) {
    for (const bool below : {true, false}) {
      std::vector<double> shape = neutral;
      const ShapeRange range = basis.shape_range(k);
      shape[k] = below ? range.lower - 0.5 : range.upper + 0.5;
      double least = 0.0;
      for (int step = 1; step < 1000; ++step) {
        for (int i = 0; i <= basis.degree(); ++i) {
          least = std::min(least, basis.evaluate(step / 1000.0, shape).d[0][i]);
        }
      }
      EXPECT_LT(least, 0.0) << "shape " << k << (below ? " below" : " above");
    }
  }
}

TEST_P(GeBezier, DerivativesFollowItsValues) {
  const std::vector<double> shape = random_shape(basis, random);
  const double t = 0.37;
  const BasisJet at = basis.evaluate(t, shape);
  const BasisJet after = basis.evaluate(t + difference_step, shape);
  const BasisJet before = basis.evaluate(t - difference_step, shape);
  for (int order = 0; order < 3; ++order) {
    for (int i = 0; i <= basis.degree(); ++i) {
      const double slope = (after.d[order][i] - before.d[order][i]) / (2.0 * difference_step);
      EXPECT_NEAR(at.d[order + 1][i], slope, difference_tolerance * (1.0 + std::abs(slope)));
    }
  }
}

TEST_P(GeBezier, IsAffineInEveryShapeParameter) {
  const std::vector<double> shape = random_shape(basis, random);
  for (int k = 0; k < basis.shape_count(); ++k) {
    std::vector<double> moved = shape;
    moved[k] += 2.5;
    const BasisJet difference = basis.shape_derivative(0.3, shape, k);
    for (int i = 0; i <= basis.degree(); ++i) {
      EXPECT_NEAR(basis.evaluate(0.3, moved).d[0][i] - basis.evaluate(0.3, shape).d[0][i],
                  2.5 * difference.d[0][i], rounding * 100);
    }
  }
}

TEST(Basis, RefusesDegreesOutsideItsRange) {
  EXPECT_THROW(GeBezierBasis(1), std::invalid_argument);
  EXPECT_THROW(GeBezierBasis(10), std::invalid_argument);
  EXPECT_THROW(BernsteinBasis(0), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::model
