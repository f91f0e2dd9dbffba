// Laws of every family of bases.

#include "model/family.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bodyline::testing {
namespace {

using model::BasisJet;

// Sums of at most 13 products of numbers that are at most 1000.
constexpr double rounding = 1e-12;
// Central differences with step 1e-5 of functions whose third derivatives are below 1e5.
constexpr double difference_step = 1e-5;
constexpr double difference_tolerance = 2e-5;
// Of the polynomials that stand for an H-Bezier basis, up to max_body_alpha; others have none to
// lose.
double form_tolerance(const std::string& family) { return family == "h-bezier" ? 1e-9 : rounding; }

struct Member {
  std::string family;
  int degree;
};

std::vector<Member> members() {
  std::vector<Member> list;
  for (const model::Family& family : model::families()) {
    for (int n = family.min_degree; n <= family.max_degree; ++n) list.push_back({family.name, n});
  }
  return list;
}

std::vector<double> random_shape(const model::AnyBasis& basis, std::mt19937& random) {
  std::vector<double> shape;
  for (int k = 0; k < basis.shape_count(); ++k) {
    const model::ShapeRange range = basis.shape_range(k), body = basis.body_range(k);
    shape.push_back(std::uniform_real_distribution<double>(
        std::max(range.lower, body.lower), std::min(range.upper, body.upper))(random));
  }
  return shape;
}

class EveryFamily : public ::testing::TestWithParam<Member> {
 protected:
  std::unique_ptr<const model::AnyBasis> basis =
      model::family(GetParam().family, GetParam().degree);
  std::mt19937 random{unsigned(GetParam().degree)};

  double from_form(const Eigen::MatrixXd& conversion, int i, double t) const {
    const model::BernsteinJet low = model::bernstein(1, t);
    Eigen::VectorXd points = conversion.row(i).transpose();
    for (Eigen::Index n = points.size() - 1; n > 0; --n) {
      for (Eigen::Index l = 0; l < n; ++l)
        points[l] = low.d[0][0] * points[l] + low.d[0][1] * points[l + 1];
    }
    return points[0];
  }
};
INSTANTIATE_TEST_SUITE_P(All, EveryFamily, ::testing::ValuesIn(members()), [](const auto& at) {
  std::string name = at.param.family + "_" + std::to_string(at.param.degree);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(EveryFamily, SumsToOneAndItsDerivativesToZero) {
  for (int trial = 0; trial <= 20; ++trial) {
    const BasisJet jet = basis->evaluate(trial / 20.0, random_shape(*basis, random));
    for (int order = 0; order < 4; ++order) {
      double sum = 0.0, size = 1.0;
      for (int i = 0; i <= basis->degree(); ++i) {
        sum += jet.d[order][i];
        size += std::abs(jet.d[order][i]);
      }
      EXPECT_NEAR(sum, order == 0 ? 1.0 : 0.0, rounding * size);
    }
  }
}

TEST_P(EveryFamily, InterpolatesItsEnds) {
  const std::vector<double> shape = random_shape(*basis, random);
  for (int i = 0; i <= basis->degree(); ++i) {
    EXPECT_NEAR(basis->evaluate(0.0, shape).d[0][i], i == 0 ? 1.0 : 0.0, rounding);
    EXPECT_NEAR(basis->evaluate(1.0, shape).d[0][i], i == basis->degree() ? 1.0 : 0.0, rounding);
  }
}

TEST_P(EveryFamily, IsBernsteinAtItsNeutralShape) {
  std::vector<double> shape;
  for (int k = 0; k < basis->shape_count(); ++k) shape.push_back(basis->neutral_shape(k));
  for (const double t : {0.0, 0.2, 0.5, 0.83, 1.0}) {
    const BasisJet jet = basis->evaluate(t, shape);
    const model::BernsteinJet expected = model::bernstein(basis->degree(), t);
    for (int order = 0; order < 4; ++order) {
      for (int i = 0; i <= basis->degree(); ++i)
        EXPECT_NEAR(jet.d[order][i], expected.d[order][i], 1e3 * rounding);
    }
  }
}

TEST_P(EveryFamily, IsNotNegativeInItsShapeRange) {
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<double> shape = random_shape(*basis, random);
    for (int step = 0; step <= 40; ++step) {
      const BasisJet jet = basis->evaluate(step / 40.0, shape);
      for (int i = 0; i <= basis->degree(); ++i) EXPECT_GE(jet.d[0][i], -rounding);
    }
  }
}

TEST_P(EveryFamily, DerivativesFollowItsValues) {
  const std::vector<double> shape = random_shape(*basis, random);
  for (const double t : {0.13, 0.5, 0.77}) {
    const BasisJet at = basis->evaluate(t, shape);
    const BasisJet after = basis->evaluate(t + difference_step, shape);
    const BasisJet before = basis->evaluate(t - difference_step, shape);
    for (int order = 0; order < 3; ++order) {
      for (int i = 0; i <= basis->degree(); ++i) {
        const double slope = (after.d[order][i] - before.d[order][i]) / (2.0 * difference_step);
        EXPECT_NEAR(at.d[order + 1][i], slope, difference_tolerance * (1.0 + std::abs(slope)));
      }
    }
  }
}

TEST_P(EveryFamily, ShapeDerivativesFollowItsValues) {
  const std::vector<double> shape = random_shape(*basis, random);
  for (int k = 0; k < basis->shape_count(); ++k) {
    std::vector<double> above = shape, below = shape;
    // Away from the ends of the range, from which on a family may refuse.
    const double middle =
        0.5 * (basis->shape_range(k).lower + std::min(4.0, basis->shape_range(k).upper));
    const double at = 0.5 * (shape[k] + middle);
    above[k] = at + difference_step;
    below[k] = at - difference_step;
    std::vector<double> here = shape;
    here[k] = at;
    double largest = 0.0;
    for (const double t : {0.21, 0.5, 0.9}) {
      const BasisJet derivative = basis->shape_derivative(t, here, k);
      const BasisJet after = basis->evaluate(t, above), before = basis->evaluate(t, below);
      for (int order = 0; order < 4; ++order) {
        for (int i = 0; i <= basis->degree(); ++i) {
          const double slope = (after.d[order][i] - before.d[order][i]) / (2.0 * difference_step);
          EXPECT_NEAR(derivative.d[order][i], slope,
                      difference_tolerance * (1.0 + std::abs(slope)));
          largest = std::max(largest, std::abs(derivative.d[order][i]));
        }
      }
    }
    EXPECT_GT(largest, 0.0) << "shape " << k;
  }
}

TEST_P(EveryFamily, BezierFormAgreesWithItsValues) {
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<double> shape = random_shape(*basis, random);
    const Eigen::MatrixXd conversion = basis->conversion(shape);
    ASSERT_EQ(conversion.rows(), basis->degree() + 1);
    ASSERT_EQ(conversion.cols(), basis->bezier_degree() + 1);
    const double t = (trial + 0.5) / 10.0;
    const BasisJet jet = basis->evaluate(t, shape);
    for (int i = 0; i <= basis->degree(); ++i)
      EXPECT_NEAR(from_form(conversion, i, t), jet.d[0][i], form_tolerance(GetParam().family));
  }
}

TEST_P(EveryFamily, BezierFormKeepsTheEnds) {
  const Eigen::MatrixXd conversion = basis->conversion(random_shape(*basis, random));
  for (int i = 0; i <= basis->degree(); ++i) {
    EXPECT_EQ(conversion(i, 0), i == 0 ? 1.0 : 0.0);
    EXPECT_EQ(conversion(i, conversion.cols() - 1), i == basis->degree() ? 1.0 : 0.0);
  }
}

TEST_P(EveryFamily, FormDerivativesFollowTheForm) {
  const std::vector<double> shape = random_shape(*basis, random);
  for (int k = 0; k < basis->shape_count(); ++k) {
    std::vector<double> above = shape, below = shape;
    const double inwards = shape[k] > 0.0 ? -1.0 : 1.0;  // one-sided ends of ranges are avoided
    const double at = shape[k] + 2.0 * inwards * difference_step;
    above[k] = at + difference_step;
    below[k] = at - difference_step;
    std::vector<double> here = shape;
    here[k] = at;
    const Eigen::MatrixXd slope =
        (basis->conversion(above) - basis->conversion(below)) / (2.0 * difference_step);
    EXPECT_LE((basis->conversion_derivative(here, k) - slope).cwiseAbs().maxCoeff(),
              difference_tolerance);
    EXPECT_GT(slope.norm(), 0.0);
    const Eigen::VectorXd abscissa_slope =
        (basis->abscissa(above) - basis->abscissa(below)) / (2.0 * difference_step);
    EXPECT_LE((basis->abscissa_derivative(here, k) - abscissa_slope).cwiseAbs().maxCoeff(),
              difference_tolerance);
  }
}

TEST_P(EveryFamily, AbscissaIsTheCurveOfEvenlySpacedPoints) {
  const int n = basis->degree();
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<double> shape = random_shape(*basis, random);
    const double t = (trial + 0.5) / 10.0;
    const BasisJet jet = basis->evaluate(t, shape);
    double expected = 0.0;
    for (int j = 0; j <= n; ++j) expected += double(j) / n * jet.d[0][j];
    EXPECT_NEAR(from_form(basis->abscissa(shape).transpose(), 0, t), expected,
                form_tolerance(GetParam().family));
    EXPECT_EQ(basis->abscissa(shape).size(), basis->abscissa_degree() + 1);
  }
}

TEST_P(EveryFamily, IsItsOwnMirrorImageWithMirroredShape) {
  const std::vector<double> shape = random_shape(*basis, random);
  std::vector<double> mirrored = shape;
  for (int k = 0; k < basis->shape_count(); ++k) mirrored[basis->mirrored_shape(k)] = shape[k];
  for (const double t : {0.1, 0.37, 0.64}) {
    const BasisJet jet = basis->evaluate(t, shape), image = basis->evaluate(1.0 - t, mirrored);
    for (int i = 0; i <= basis->degree(); ++i)
      EXPECT_NEAR(jet.d[0][i], image.d[0][basis->degree() - i], rounding);
  }
}

TEST(Family, RefusesUnknownNamesAndListsTheKnown) {
  try {
    model::family("bezier", 3);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "there is no basis \"bezier\"; known are ge-bezier, bezier-like, h-bezier");
  }
}

TEST(Family, RefusesDegreesThatItDoesNotHave) {
  EXPECT_THROW(model::family("h-bezier", 2), std::invalid_argument);
  EXPECT_THROW(model::family("bezier-like", 1), std::invalid_argument);
  EXPECT_THROW(model::family("ge-bezier", 10), std::invalid_argument);
}

TEST(Family, CountsShapeParametersOfPatches) {
  const auto counts = [](const char* name) { return model::shape_counts(name, 5, 3); };
  EXPECT_EQ(counts("ge-bezier").u, 4);
  EXPECT_EQ(counts("ge-bezier").v, 2);
  EXPECT_EQ(counts("bezier-like").u, 1);
  EXPECT_EQ(counts("bezier-like").v, 6);
  EXPECT_EQ(counts("h-bezier").u, 3);
  EXPECT_EQ(counts("h-bezier").v, 3);
}

}  // namespace
}  // namespace bodyline::testing
