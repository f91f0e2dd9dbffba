// The H-Bezier basis against its printed formulas, its bounds and its limits (docs/families.md,
// section 3).

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "golden.hpp"
#include "model/basis_h_bezier.hpp"
#include "model/dual.hpp"
#include "model/h_bezier_functions.hpp"

namespace bodyline::testing {
namespace {

using model::BasisJet;
using model::HBezierBasis;
using Alphas = std::array<double, 3>;
using Long = long double;

constexpr double rounding = 1e-14;
constexpr double complex_step = 1e-100;

// Eq. (3) as printed, in numbers of 64 bits of mantissa; from alpha = 1 it loses at most 3 digits.
Long printed_f1(Long a, Long t) {
  return (a * t - std::sinh(a) + std::sinh(a * (1 - t))) / (a - std::sinh(a));
}
Long printed_f2(Long a, Long t) {
  return (a * t * std::cosh(a) + std::sinh(a * (1 - t)) - std::sinh(a) - std::sinh(a * t) + a * t) /
         (a * std::cosh(a) - 2 * std::sinh(a) + a);
}
Long printed_f3(Long a, Long t) { return (a * t - std::sinh(a * t)) / (a - std::sinh(a)); }

TEST(HBezier, AgreesWithGoldenNumbers) {
  for (const auto& entry : golden("h_bezier_basis")) {
    const Alphas alpha = entry["alpha"];
    const BasisJet jet = HBezierBasis().evaluate(entry["t"], alpha);
    const char* const keys[] = {"d0", "d1", "d2", "d3"};
    for (int order = 0; order < 4; ++order) {
      for (int i = 0; i < 4; ++i) {
        const double expected = entry[keys[order]][i];
        EXPECT_NEAR(jet.d[order][i], expected, golden_tolerance * (1.0 + std::abs(expected)));
      }
    }
  }
}

TEST(HBezier, EndConstantsAgreeWithGoldenNumbers) {
  for (const auto& entry : golden("h_bezier_constants")) {
    const double alpha = entry["alpha"];
    const auto expect = [](double actual, double expected) {
      EXPECT_NEAR(actual, expected, golden_tolerance * expected);
    };
    expect(model::h_bezier_k1(alpha), entry["k1"]);
    expect(model::h_bezier_k2(alpha), entry["k2"]);
    expect(model::h_bezier_k3(alpha), entry["k3"]);
  }
}

TEST(HBezier, AlphaDerivativesAgreeWithGoldenNumbers) {
  for (const auto& entry : golden("h_bezier_alpha_derivatives")) {
    const double alpha = entry["alpha"], t = entry["t"];
    const model::Dual a(alpha, 1.0);
    const double slopes[] = {model::h_bezier_f1(a, t)[0].slope, model::h_bezier_f2(a, t)[0].slope,
                             model::h_bezier_f3(a, t)[0].slope};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(slopes[k], entry["df"][k], golden_tolerance);
  }
}

TEST(HBezier, AgreesWithThePrintedFormulas) {
  for (const double a : {1.0, 1.9, 2.1, 3.9, 4.1, 10.0, 40.0}) {
    for (const double t : {0.01, 0.3, 0.5, 0.95}) {
      EXPECT_NEAR(model::h_bezier_f1(a, t)[0], double(printed_f1(a, t)), rounding);
      EXPECT_NEAR(model::h_bezier_f2(a, t)[0], double(printed_f2(a, t)), rounding);
      EXPECT_NEAR(model::h_bezier_f3(a, t)[0], double(printed_f3(a, t)), rounding);
    }
  }
}

// Eq. (8) prints a further factor t in the denominator of f2; the functions then sum to one but
// leave [0, 1].
TEST(HBezier, PrintedDenominatorOfEquation8IsWrong) {
  const Long a = 1.0, t = 0.3;
  const Long printed =
      (a * t * std::cosh(a) + std::sinh(a * (1 - t)) - std::sinh(a) - std::sinh(a * t) + a * t) /
      (a * t * std::cosh(a) - 2 * std::sinh(a) + a);
  EXPECT_LT(printed, -0.04L);
  EXPECT_NEAR(model::h_bezier_f2(1.0, 0.3)[0], 0.217, 1e-3);
}

// Derivatives by alpha from dual and from complex numbers, on both sides of every branch.
TEST(HBezier, AlphaDerivativesAreTheComplexStepOfAllOrders) {
  for (const double alpha : {1e-6, 0.3, 1.99, 2.01, 3.99, 4.01, 25.0}) {
    for (const double t : {0.0, 0.12, 0.5, 0.8, 1.0}) {
      const model::Dual a(alpha, 1.0);
      const std::complex<double> z(alpha, complex_step);
      const auto expect = [&](const auto& dual, const auto& complex) {
        for (int order = 0; order < 4; ++order) {
          const double expected = complex[order].imag() / complex_step;
          EXPECT_NEAR(dual[order].slope, expected,
                      10.0 * rounding * (1.0 + std::abs(dual[order].value)));
        }
      };
      expect(model::h_bezier_f1(a, t), model::h_bezier_f1(z, t));
      expect(model::h_bezier_f2(a, t), model::h_bezier_f2(z, t));
      expect(model::h_bezier_f3(a, t), model::h_bezier_f3(z, t));
    }
  }
}

TEST(HBezier, BranchesMeet) {
  for (const double limit : {2.0, 4.0}) {
    const double below = std::nextafter(limit, 0.0);
    for (const double t : {0.0, 0.2, 0.5, 0.7, 1.0}) {
      for (int order = 0; order < 4; ++order) {
        const auto expect = [&](double a, double b) {
          EXPECT_NEAR(a, b, 20.0 * rounding * (1.0 + std::abs(a)));
        };
        expect(model::h_bezier_f1(limit, t)[order], model::h_bezier_f1(below, t)[order]);
        expect(model::h_bezier_f2(limit, t)[order], model::h_bezier_f2(below, t)[order]);
        expect(model::h_bezier_f3(limit, t)[order], model::h_bezier_f3(below, t)[order]);
      }
    }
  }
}

// f1 >= 1-(1-t)^3 >= max(t, 3t^2-2t^3) >= f2 >= min(t, 3t^2-2t^3) >= t^3 >= f3: so every h_i >= 0.
TEST(HBezier, IsNotNegativeForEveryAlpha) {
  for (const double alpha : {0.0, 1e-9, 1e-3, 0.5, 2.0, 4.0, 37.0, 710.0, 1e4, 1e6}) {
    for (int step = 0; step <= 100; ++step) {
      const double t = step / 100.0, smooth = t * t * (3.0 - 2.0 * t);
      const double f1 = model::h_bezier_f1(alpha, t)[0], f2 = model::h_bezier_f2(alpha, t)[0],
                   f3 = model::h_bezier_f3(alpha, t)[0];
      EXPECT_GE(f1, 1.0 - std::pow(1.0 - t, 3) - rounding);
      EXPECT_LE(f2, std::max(t, smooth) + rounding);
      EXPECT_GE(f2, std::min(t, smooth) - rounding);
      EXPECT_LE(f3, t * t * t + rounding);
      EXPECT_GE(f3, 0.0);
      EXPECT_LE(f1, 1.0);
    }
  }
}

TEST(HBezier, AllDerivativesAreFiniteForEveryAlpha) {
  for (const double alpha : {0.0, 1e-300, 1e-9, 2.0, 700.0, 711.0, 1e4, 1e6}) {
    for (const double t : {0.0, 1e-12, 0.25, 0.5, 1.0 - 1e-12, 1.0}) {
      const Alphas alphas{alpha, alpha, alpha};
      const BasisJet jet = HBezierBasis().evaluate(t, alphas);
      for (int k = 0; k < 3; ++k) {
        const BasisJet slope = HBezierBasis().shape_derivative(t, alphas, k);
        for (int order = 0; order < 4; ++order) {
          for (int i = 0; i < 4; ++i) {
            EXPECT_TRUE(std::isfinite(jet.d[order][i])) << alpha << " " << t;
            EXPECT_TRUE(std::isfinite(slope.d[order][i])) << alpha << " " << t;
          }
        }
      }
    }
  }
}

TEST(HBezier, ApproachesTheCubicQuadratically) {
  // The difference is c alpha^2 with c below 0.02.
  for (const double alpha : {1e-1, 1e-2, 1e-3}) {
    for (const double t : {0.2, 0.5, 0.9}) {
      EXPECT_LE(std::abs(model::h_bezier_f1(alpha, t)[0] - (1.0 - std::pow(1.0 - t, 3))),
                0.02 * alpha * alpha + rounding);
    }
  }
}

TEST(HBezier, ApproachesItsPolygonForLargeAlpha) {
  EXPECT_NEAR(model::h_bezier_f1(1e6, 0.01)[0], 1.0, rounding);
  EXPECT_NEAR(model::h_bezier_f2(1e6, 0.3)[0], 0.3, 1e-6);
  EXPECT_NEAR(model::h_bezier_f3(1e6, 0.99)[0], 0.0, rounding);
}

TEST(HBezier, MovesAlongTheEdgesInThePrintedDirections) {
  for (const double alpha : {0.1, 1.0, 5.0, 30.0}) {
    const model::Dual a(alpha, 1.0);
    for (const double t : {0.1, 0.4, 0.6, 0.9}) {
      EXPECT_GT(model::h_bezier_f1(a, t)[0].slope, 0.0);
      EXPECT_EQ(model::h_bezier_f2(a, t)[0].slope > 0.0, t < 0.5);
      EXPECT_LT(model::h_bezier_f3(a, t)[0].slope, 0.0);
    }
    EXPECT_NEAR(model::h_bezier_f2(a, 0.5)[0].slope, 0.0, rounding);
    EXPECT_NEAR(model::h_bezier_f2(a, 0.5)[0].value, 0.5, rounding);
  }
}

// Item (c) of the paper's section 2.2 says the curve comes nearer to P3 as alpha 3 grows: the
// weight moves from P3 to P2.
TEST(HBezier, LastAlphaDrawsTowardsTheThirdPoint) {
  for (const double t : {0.3, 0.8}) {
    const BasisJet slope = HBezierBasis().shape_derivative(t, Alphas{1.0, 2.0, 1.5}, 2);
    EXPECT_GT(slope.d[0][2], 0.0);
    EXPECT_LT(slope.d[0][3], 0.0);
  }
}

// As alpha grows a point moves on a straight line but not at constant speed, as section 2.2 says.
TEST(HBezier, PointsDoNotMoveLinearlyWithAlpha) {
  const double t = 0.3;
  const double first = model::h_bezier_f1(2.0, t)[0] - model::h_bezier_f1(1.0, t)[0];
  const double second = model::h_bezier_f1(3.0, t)[0] - model::h_bezier_f1(2.0, t)[0];
  EXPECT_GT(std::abs(first - second), 1e-3);
}

// Equal alphas: the abscissas (0, 1/k1, 1 - 1/k1, 1) give t, so that straight lines and catenaries
// are reproduced.
TEST(HBezier, ReproducesTheCatenaryWithEqualAlphas) {
  for (const double a : {0.5, 2.5, 6.0}) {
    const double k1 = model::h_bezier_k1(a);
    const double p = std::cosh(a / 2), q = p - a * std::sinh(a / 2) / k1;
    for (const double t : {0.1, 0.45, 0.8}) {
      const BasisJet h = HBezierBasis().evaluate(t, Alphas{a, a, a});
      EXPECT_NEAR(h.d[0][1] / k1 + h.d[0][2] * (1.0 - 1.0 / k1) + h.d[0][3], t, rounding);
      const double ordinate = p * (h.d[0][0] + h.d[0][3]) + q * (h.d[0][1] + h.d[0][2]);
      EXPECT_NEAR(ordinate, std::cosh(a * (t - 0.5)), 10.0 * rounding * p);
    }
  }
}

TEST(HBezier, UnequalAlphasReproduceNoLine) {
  const BasisJet h = HBezierBasis().evaluate(0.3, Alphas{1.0, 4.0, 1.0});
  const double k1 = model::h_bezier_k1(1.0);
  EXPECT_GT(std::abs(h.d[0][1] / k1 + h.d[0][2] * (1.0 - 1.0 / k1) + h.d[0][3] - 0.3), 1e-3);
}

// h0''(0) has the sign opposite to the first term of h1''(0); the text prints them alike.
TEST(HBezier, SecondEndDerivativesHaveTheirSigns) {
  const Alphas a{1.2, 2.5, 0.7};
  const BasisJet at0 = HBezierBasis().evaluate(0.0, a), at1 = HBezierBasis().evaluate(1.0, a);
  const double tolerance = 100.0 * rounding;
  const double k2 = model::h_bezier_k2(a[0]), k3 = model::h_bezier_k3(a[1]);
  EXPECT_NEAR(at0.d[2][0], k2, tolerance);
  EXPECT_NEAR(at0.d[2][1], -k2 - k3, tolerance);
  EXPECT_NEAR(at0.d[2][2], k3, tolerance);
  EXPECT_NEAR(at0.d[2][3], 0.0, tolerance);
  EXPECT_NEAR(at1.d[2][3], model::h_bezier_k2(a[2]), tolerance);
  EXPECT_NEAR(at1.d[2][1], k3, tolerance);
  EXPECT_NEAR(at1.d[1][3], model::h_bezier_k1(a[2]), tolerance);
  EXPECT_NEAR(at0.d[1][0], -model::h_bezier_k1(a[0]), tolerance);
}

TEST(HBezier, BezierFormIsGivenUpToItsLimit) {
  const HBezierBasis basis;
  const auto worst = [&](double alpha) {
    const Alphas alphas{alpha, alpha, alpha};
    const Eigen::VectorXd points = basis.abscissa(alphas);
    double most = 0.0;
    for (int step = 0; step <= 200; ++step) {
      const model::BernsteinJet bernstein = model::bernstein(int(points.size()) - 1, step / 200.0);
      const BasisJet jet = basis.evaluate(step / 200.0, alphas);
      double sum = -(jet.d[0][1] + 2.0 * jet.d[0][2]) / 3.0 - jet.d[0][3];
      for (int l = 0; l < points.size(); ++l) sum += points[l] * bernstein.d[0][l];
      most = std::max(most, std::abs(sum));
    }
    return most;
  };
  EXPECT_LE(worst(HBezierBasis::max_body_alpha), 5e-10);
  EXPECT_LE(worst(HBezierBasis::max_bezier_alpha), 1e-6);
  EXPECT_THROW(basis.conversion(Alphas{0.0, 8.1, 0.0}), std::invalid_argument);
  EXPECT_NO_THROW(basis.evaluate(0.5, Alphas{0.0, 8.1, 0.0}));
}

TEST(HBezier, RefusesParametersOutsideItsRange) {
  const HBezierBasis basis;
  for (const double bad : {-1e-9, std::nan(""), double(INFINITY), 1.1e6}) {
    EXPECT_THROW(basis.evaluate(0.5, Alphas{1.0, bad, 1.0}), std::invalid_argument);
    EXPECT_THROW(basis.shape_derivative(0.5, Alphas{1.0, bad, 1.0}, 0), std::invalid_argument);
  }
  EXPECT_THROW(basis.evaluate(0.5, std::array{1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(HBezierBasis(2), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::testing
