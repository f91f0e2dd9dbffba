// The Bezier-like basis against its printed and re-derived formulas (docs/families.md, section 2).

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "golden.hpp"
#include "model/basis_bezier_like.hpp"

namespace bodyline::testing {
namespace {

using model::BasisJet;
using model::BezierLikeBasis;

constexpr double rounding = 1e-13;  // sums of ten products of numbers up to 10

double value(int n, int i, double t, double lambda) {
  return BezierLikeBasis(n).evaluate(t, std::array{lambda}).d[0][i];
}

TEST(BezierLike, AgreesWithGoldenNumbers) {
  for (const auto& entry : golden("bezier_like_basis")) {
    const int n = entry["n"];
    for (int i = 0; i <= n; ++i)
      EXPECT_NEAR(value(n, i, entry["t"], entry["lam"]), entry["b"][i], golden_tolerance);
  }
}

TEST(BezierLike, QuadraticFunctionsAreTheDefinition) {
  for (const double lambda : {-1.0, -0.3, 0.0, 0.8, 1.0}) {
    for (const double t : {0.0, 0.2, 0.5, 0.9}) {
      const double s = 1.0 - t;
      EXPECT_NEAR(value(2, 0, t, lambda), s * s * (1 - 2 * lambda * t + lambda * t * t), rounding);
      EXPECT_NEAR(value(2, 1, t, lambda), 2 * s * t * (1 + lambda - lambda * t + lambda * t * t),
                  rounding);
      EXPECT_NEAR(value(2, 2, t, lambda), t * t * (1 - lambda + lambda * t * t), rounding);
    }
  }
}

TEST(BezierLike, HigherDegreesFollowTheRecursion) {
  for (int n = 3; n <= 9; ++n) {
    for (const double t : {0.15, 0.6}) {
      for (int i = 0; i <= n; ++i) {
        const double left = i < n ? value(n - 1, i, t, 0.7) : 0.0;
        const double right = i > 0 ? value(n - 1, i - 1, t, 0.7) : 0.0;
        EXPECT_NEAR(value(n, i, t, 0.7), (1 - t) * left + t * right, rounding);
      }
    }
  }
}

TEST(BezierLike, EndConstantsAgreeWithGoldenNumbers) {
  for (const auto& entry : golden("bezier_like_ends")) {
    const model::BezierLikeEnds ends = model::bezier_like_ends(entry["n"], entry["lam"]);
    EXPECT_NEAR(ends.d, entry["D"], golden_tolerance * 100);
    EXPECT_NEAR(ends.a, entry["A"], golden_tolerance * 100);
    EXPECT_NEAR(ends.b, entry["B"], golden_tolerance * 100);
  }
}

TEST(BezierLike, EndDerivativesAreTheEndConstants) {
  for (int n = 2; n <= 9; ++n) {
    for (const double lambda : {-0.9, 0.4, 1.0}) {
      const model::BezierLikeEnds ends = model::bezier_like_ends(n, lambda);
      const BasisJet at0 = BezierLikeBasis(n).evaluate(0.0, std::array{lambda});
      const BasisJet at1 = BezierLikeBasis(n).evaluate(1.0, std::array{lambda});
      const double size = 1e3 * rounding;
      EXPECT_NEAR(at0.d[1][0], -ends.d, size);
      EXPECT_NEAR(at0.d[1][1], ends.d, size);
      EXPECT_NEAR(at0.d[2][0], ends.a, size);
      EXPECT_NEAR(at0.d[2][1], -(ends.a + ends.b), size);
      EXPECT_NEAR(at0.d[2][2], ends.b, size);
      EXPECT_NEAR(at1.d[1][n], ends.d, size);
      EXPECT_NEAR(at1.d[2][n], ends.a, size);
      EXPECT_NEAR(at1.d[2][n - 2], ends.b, size);
      for (int i = 3; i <= n; ++i) EXPECT_NEAR(at0.d[2][i], 0.0, size);
    }
  }
}

TEST(BezierLike, ConversionAgreesWithGoldenNumbers) {
  for (const auto& entry : golden("bezier_like_conversion")) {
    const int n = entry["n"];
    const double lambda = entry["lam"];
    const Eigen::MatrixXd form = BezierLikeBasis(n).conversion(std::array{lambda});
    for (int k = 0; k <= n + 2; ++k) {
      for (int i = 0; i <= n; ++i) EXPECT_NEAR(form(i, k), entry["M"][k][i], golden_tolerance);
    }
  }
}

TEST(BezierLike, ConversionTakesMeansOfFullRank) {
  for (int n = 2; n <= 9; ++n) {
    for (const double lambda : {-1.0, 0.0, 0.5, 1.0}) {
      const Eigen::MatrixXd form = BezierLikeBasis(n).conversion(std::array{lambda});
      EXPECT_LE((form.colwise().sum().array() - 1.0).abs().maxCoeff(), rounding);
      EXPECT_GE(form.minCoeff(), -rounding);
      EXPECT_EQ(Eigen::FullPivLU<Eigen::MatrixXd>(form).rank(), n + 1);
    }
  }
}

TEST(BezierLike, QuadraticConversionIsAsDerivedByHand) {
  const double l = 0.3;
  Eigen::MatrixXd expected(5, 3);
  expected << 1, 0, 0, (1 - l) / 2, (1 + l) / 2, 0, (1 - l) / 6, (2 + l) / 3, (1 - l) / 6, 0,
      (1 + l) / 2, (1 - l) / 2, 0, 0, 1;
  const Eigen::MatrixXd form = BezierLikeBasis(2).conversion(std::array{l});
  EXPECT_LE((form.transpose() - expected).cwiseAbs().maxCoeff(), rounding);
}

// d/d lambda of a curve point = s^2 (1-s^2) (Q1-Q0) + t^2 (1-t^2) (Q1-Q2), whatever lambda is.
TEST(BezierLike, ShapeDerivativeIsThatOfTheLastDeCasteljauPoints) {
  const int n = 4;
  const double t = 0.37, s = 1.0 - t;
  std::array<double, 5> q{2.0, -1.0, 0.5, 3.0, 1.0};
  const std::array<double, 5> p = q;
  for (int step = n; step > 2; --step) {
    for (int k = 0; k < step; ++k) q[k] = s * q[k] + t * q[k + 1];
  }
  const double expected = s * s * (1 - s * s) * (q[1] - q[0]) + t * t * (1 - t * t) * (q[1] - q[2]);
  for (const double lambda : {-0.5, 0.9}) {
    const BasisJet jet = BezierLikeBasis(n).shape_derivative(t, std::array{lambda}, 0);
    double actual = 0.0;
    for (int i = 0; i <= n; ++i) actual += jet.d[0][i] * p[i];
    EXPECT_NEAR(actual, expected, rounding);
  }
}

// The span has no linear function: evenly spaced points do not give t (spec of the basis).
TEST(BezierLike, HasNoLinearPrecision) {
  const Eigen::VectorXd abscissa = BezierLikeBasis(3).abscissa(std::array{0.5});
  EXPECT_GT((abscissa - Eigen::VectorXd::LinSpaced(4, 0.0, 1.0)).cwiseAbs().maxCoeff(), 0.1);
}

TEST(BezierLike, RefusesParametersOutsideItsRange) {
  const BezierLikeBasis basis(3);
  for (const double bad : {-1.001, 1.001, std::nan(""), double(INFINITY)}) {
    EXPECT_THROW(basis.evaluate(0.5, std::array{bad}), std::invalid_argument);
    EXPECT_THROW(basis.conversion(std::array{bad}), std::invalid_argument);
  }
  EXPECT_THROW(basis.evaluate(0.5, std::array{0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(BezierLikeBasis(1), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::testing
