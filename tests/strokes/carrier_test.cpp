#include "strokes/carrier.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "model/random.hpp"
#include "strokes/base_net.hpp"
#include "strokes/fit_carrier.hpp"
#include "strokes/fit_stroke.hpp"
#include "tests/strokes/expect_derivatives.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::expect_derivatives;

// Sums of a few dozen products of numbers up to 1000.
constexpr double rounding_mm = 1e-10;

std::vector<model::SplineCurve> random_loop(std::uint64_t seed, std::size_t sides) {
  for (;; ++seed) {
    model::Random random(seed);
    const auto loop = test::random_boundary(random);
    if (loop.size() != sides) continue;
    std::vector<model::SplineCurve> curves;
    for (const Points& side : loop) curves.push_back(fit_stroke(side, 1.0).curve);
    return curves;
  }
}

TEST(BlendedSurface, FollowsItsBorder) {
  for (const std::size_t sides : {3u, 4u}) {
    const auto loop = random_loop(1, sides);
    const SurfaceFunction surface = blended_surface(loop);
    const Polygon domain = base_domain(sides);
    for (std::size_t k = 0; k < sides; ++k) {
      for (const double t : {0.0, 0.1, 0.62, 1.0}) {
        const Vector2d place = (1.0 - t) * domain[k] + t * domain[(k + 1) % sides];
        EXPECT_LE((surface(place).point - model::curve_point(loop[k], t)).norm(), rounding_mm);
      }
    }
  }
}

TEST(BlendedSurface, DerivativesAreThoseOfThePoints) {
  expect_derivatives(blended_surface(random_loop(2, 4)), {0.31, 0.72});
  expect_derivatives(blended_surface(random_loop(3, 3)), {0.47, 0.33});
  // The first piece beside a corner of the triangle is another formula.
  expect_derivatives(blended_surface(random_loop(3, 3)), {0.03, 0.01});
}

TEST(BlendedSurface, OfThreeSidesDoesNotPreferAny) {
  auto loop = random_loop(4, 3);
  const SurfaceFunction surface = blended_surface(loop);
  std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  const SurfaceFunction turned = blended_surface(loop);
  const Polygon domain = base_domain(3);
  const Vector3d weights(0.2, 0.5, 0.3);
  Vector2d place = Vector2d::Zero(), turned_place = Vector2d::Zero();
  for (int k = 0; k < 3; ++k) {
    place += weights[k] * domain[k];
    turned_place += weights[(k + 1) % 3] * domain[k];
  }
  EXPECT_LE((surface(place).point - turned(turned_place).point).norm(), rounding_mm);
}

TEST(BlendedSurface, OfAPlaneIsThePlane) {
  std::vector<model::SplineCurve> loop;
  const Polygon domain = base_domain(3);
  for (int k = 0; k < 3; ++k) {
    const Vector2d a = domain[k], b = domain[(k + 1) % 3];
    loop.push_back({1, {0.0, 1.0}, {{a.x(), a.y(), 2 * a.x()}, {b.x(), b.y(), 2 * b.x()}}});
  }
  const PatchJet jet = blended_surface(loop)({0.4, 0.3});
  EXPECT_LE((jet.point - Vector3d(0.4, 0.3, 0.8)).norm(), 1e-14);
  EXPECT_LE((jet.s - Vector3d(1, 0, 2)).norm(), 1e-13);
}

SurfaceFunction flat() {
  return [](const Vector2d& place) {
    const Vector3d none = Vector3d::Zero();
    return PatchJet{{1000.0 * place.x(), 700.0 * place.y(), 0.0},
                    {1000.0, 0.0, 0.0},
                    {0.0, 700.0, 0.0},
                    none,
                    none,
                    none};
  };
}

Carrier random_carrier(const CarrierBasis& basis) {
  model::Random random(5);
  Eigen::MatrixX3d coefficients(basis.count(), 3);
  for (int k = 0; k < basis.count(); ++k)
    coefficients.row(k) << 0.0, 0.0, 100.0 * (random.uniform() - 0.5);
  return {flat(), basis, coefficients};
}

TEST(Carrier, DerivativesAreThoseOfThePoints) {
  for (const std::size_t sides : {3u, 4u}) {
    for (const int order : {1, 2}) {
      const Carrier carrier = random_carrier({base_domain(sides), order, 8});
      expect_derivatives([&](const Vector2d& place) { return carrier.jet(place); }, {0.43, 0.29});
    }
  }
}

TEST(Carrier, IsTheBaseOnTheBorder) {
  for (const std::size_t sides : {3u, 4u}) {
    const Polygon domain = base_domain(sides);
    const Carrier free = random_carrier({domain, 1, 8}), held = random_carrier({domain, 2, 8});
    for (std::size_t k = 0; k < sides; ++k) {
      const Vector2d place = 0.3 * domain[k] + 0.7 * domain[(k + 1) % sides];
      EXPECT_LE((free.jet(place).point - flat()(place).point).norm(), rounding_mm);
      EXPECT_GT(free.jet(place).s.z() * free.jet(place).s.z() +
                    free.jet(place).t.z() * free.jet(place).t.z(),
                1.0);
      EXPECT_LE((held.jet(place).s - flat()(place).s).norm(), rounding_mm);
      EXPECT_LE((held.jet(place).t - flat()(place).t).norm(), rounding_mm);
    }
  }
}

TEST(Carrier, FeetAreWhereTheWayIsSquare) {
  const Carrier carrier = random_carrier({base_domain(4), 1, 8});
  const PatchJet at = carrier.jet({0.4, 0.6});
  const Vector3d point = at.point + 15.0 * at.s.cross(at.t).normalized();
  const Vector2d foot = carrier_foot(carrier, {0.42, 0.58}, point);
  EXPECT_LE((foot - Vector2d(0.4, 0.6)).norm(), 1e-6);
}

TEST(Carrier, FeetStayInTheDomain) {
  const Carrier carrier = random_carrier({base_domain(4), 1, 8});
  const Vector2d foot = carrier_foot(carrier, {0.9, 0.5}, {1200.0, 350.0, 0.0});
  EXPECT_LE((foot - Vector2d(1.0, 0.5)).norm(), 0.05);
  EXPECT_EQ(foot.x(), 1.0);
}

// The ridge on the diagonal and the conditions of the equations.
constexpr double solved_mm = 1e-4;

TEST(CarrierEquations, FindTheCarrierThatSamplesComeFrom) {
  const CarrierBasis basis{base_domain(4), 1, 8};
  const Carrier wanted = random_carrier(basis);
  std::vector<CarrierSample> samples;
  for (double s = 0.01; s < 1.0; s += 0.02)
    for (double t = 0.01; t < 1.0; t += 0.02)
      samples.push_back({{s, t}, wanted.jet({s, t}).point, 1.0});
  CarrierEquations equations(flat(), basis);
  equations.set_samples(samples);
  const auto found = equations.solve(0.0);
  ASSERT_TRUE(found);
  EXPECT_LE((found->jet({0.333, 0.777}).point - wanted.jet({0.333, 0.777}).point).norm(),
            solved_mm);
}

TEST(CarrierEquations, OverATriangleHaveNoRipplesAlongTheBorder) {
  // Functions of which hardly anything lies inside must not be free: they show in the derivative
  // across the border, in waves shorter than the cells of the grid.
  const Polygon domain = base_domain(3);
  const SurfaceFunction base = blended_surface(random_loop(3, 3));
  const auto found = CarrierEquations(base, {domain, 1, 8}).solve(1.0);
  ASSERT_TRUE(found);
  constexpr double apart = 0.02;
  const auto across = [&](double t) {
    const PatchJet jet = found->jet((1.0 - t) * domain[1] + t * domain[2]);
    return Vector3d(0.866 * jet.s + 0.5 * jet.t);
  };
  double sharpest = 0.0;
  for (double t = 0.1; t < 0.9; t += 0.005)
    sharpest = std::max(sharpest, (across(t - apart) - 2.0 * across(t) + across(t + apart)).norm());
  // Without the energy outside it is over 100 mm.
  EXPECT_LE(sharpest, 10.0);
}

TEST(CarrierEquations, WithoutSamplesFlattenTheBase) {
  // The bumps of the base lie in the space of displacements, so the fairest surface is the plane.
  for (const std::size_t sides : {3u, 4u}) {
    const CarrierBasis basis{base_domain(sides), 1, 8};
    const Carrier bumpy = random_carrier(basis);
    const CarrierEquations equations([&](const Vector2d& place) { return bumpy.jet(place); },
                                     basis);
    const auto found = equations.solve(1.0);
    ASSERT_TRUE(found);
    const double bump = std::abs(bumpy.jet({0.47, 0.31}).point.z());
    EXPECT_GT(bump, 1.0);
    // What is left for a triangle is that a ten-thousandth of the energy outside counts.
    const double left = sides == 3 ? 0.01 * bump : solved_mm;
    EXPECT_LE(std::abs(found->jet({0.47, 0.31}).point.z()), left);
  }
}

TEST(CarrierEquations, FairDisplacementsWithoutSamplesVanish) {
  const CarrierBasis basis{base_domain(4), 1, 8};
  const Carrier bumpy = random_carrier(basis);
  const CarrierEquations equations([&](const Vector2d& place) { return bumpy.jet(place); }, basis,
                                   Fair::displacement);
  const auto found = equations.solve(1.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->jet({0.47, 0.31}).point, bumpy.jet({0.47, 0.31}).point);
}

std::vector<CarrierSample> wave_samples() {
  std::vector<CarrierSample> samples;
  for (const double t : {0.3, 0.6})
    for (double s = 0.05; s <= 0.95; s += 0.01)
      samples.push_back(
          {{s, t},
           {1000.0 * s, 700.0 * t, 20.0 * std::sin(9.0 * s) + 0.5 * std::sin(120.0 * s)},
           0.01});
  return samples;
}

TEST(FitCarrier, KeepsToTheTolerance) {
  for (const double tolerance_mm : {0.1, 1.0, 5.0}) {
    CarrierOptions options;
    options.tolerance_mm = tolerance_mm;
    const CarrierFit fit = fit_carrier(flat(), base_domain(4), wave_samples(), options);
    EXPECT_LE(fit.deviation_mm, tolerance_mm);
    for (const CarrierSample& sample : wave_samples()) {
      const Vector2d foot = carrier_foot(fit.carrier, sample.place, sample.point);
      EXPECT_LE((fit.carrier.jet(foot).point - sample.point).norm(), tolerance_mm * (1.0 + 1e-6));
    }
  }
}

double bending(const Carrier& carrier) {
  double sum = 0.0;
  for (double s = 0.025; s < 1.0; s += 0.05) {
    for (double t = 0.025; t < 1.0; t += 0.05) {
      const PatchJet jet = carrier.jet({s, t});
      sum += jet.ss.squaredNorm() + 2.0 * jet.st.squaredNorm() + jet.tt.squaredNorm();
    }
  }
  return sum;
}

TEST(FitCarrier, IsFairerWhenAskedAndStillKeepsToTheTolerance) {
  CarrierOptions options;
  options.tolerance_mm = 2.0;
  const CarrierFit close = fit_carrier(flat(), base_domain(4), wave_samples(), options);
  options.fair = true;
  const CarrierFit fair = fit_carrier(flat(), base_domain(4), wave_samples(), options);
  EXPECT_LE(fair.deviation_mm, options.tolerance_mm);
  EXPECT_GT(fair.fairness, 10.0 * close.fairness);
  EXPECT_LT(bending(fair.carrier), 0.9 * bending(close.carrier));
}

TEST(FitCarrier, LeavesABaseThatHoldsAllSamples) {
  const Carrier base = random_carrier({base_domain(4), 2, 8});
  const SurfaceFunction surface = [&](const Vector2d& place) { return base.jet(place); };
  std::vector<CarrierSample> samples;
  for (double s = 0.1; s < 0.9; s += 0.01) {
    const Vector3d point = base.jet({s, 0.5}).point;
    samples.push_back({{s + 0.01, 0.49}, point, 0.01});
  }
  const CarrierFit fit = fit_carrier(surface, base_domain(4), samples,
                                     {.tolerance_mm = 1.0, .border_order = 2, .slides = false});
  EXPECT_EQ(fit.fairness, 0.0);
  EXPECT_LE((fit.carrier.jet({0.31, 0.2}).point - base.jet({0.31, 0.2}).point).norm(), rounding_mm);
}

TEST(FitCarrier, KeepsABumpyBaseFarFromALiftedStroke) {
  const Carrier base = random_carrier({base_domain(4), 2, 8});
  const SurfaceFunction surface = [&](const Vector2d& place) { return base.jet(place); };
  constexpr double lift_mm = 8.0, tolerance_mm = 1.0, far_mm = 0.25 * tolerance_mm;
  std::vector<CarrierSample> samples;
  for (double s = 0.1; s < 0.3; s += 0.01) {
    const double lift = std::sin(5.0 * std::numbers::pi * (s - 0.1));
    samples.push_back(
        {{s, 0.2}, base.jet({s, 0.2}).point + lift_mm * lift * lift * Vector3d::UnitZ(), 0.01});
  }
  for (const bool fair : {false, true}) {
    const CarrierFit fit = fit_carrier(
        surface, base_domain(4), samples,
        {.tolerance_mm = tolerance_mm, .fair = fair, .border_order = 2, .slides = false});
    EXPECT_LE(fit.deviation_mm, tolerance_mm);
    EXPECT_GT(fit.fairness, 0.0);
    for (const Vector2d& place : {Vector2d(0.8, 0.5), Vector2d(0.6, 0.7), Vector2d(0.5, 0.85)})
      EXPECT_LE((fit.carrier.jet(place).point - base.jet(place).point).norm(), far_mm) << fair;
  }
}
}  // namespace
}  // namespace bodyline::strokes
