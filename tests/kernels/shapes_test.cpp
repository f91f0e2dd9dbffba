#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/kernels/faces.hpp"

namespace bodyline::test {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

const model::Kernels& best() { return model::kernels(model::best_isa()); }

double energy(const Face& face, Energy which) { return energy_value(best(), face, which); }

/// Geographic patch of a sphere: longitude -1/2..1/2, latitude -1/2..1/2.
Vector3d sphere_point(double radius, double u, double v) {
  const double a = u - 0.5, b = v - 0.5;
  return radius * Vector3d(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
}

Vector3d cylinder_point(double radius, double u, double v) {
  return {radius * std::cos(u), radius * std::sin(u), 3.0 * v};
}

TEST(Shapes, ASphereBendsByTwiceItsSolidAngleWhateverItsRadius) {
  const double solid_angle = 2.0 * std::sin(0.5);
  double previous_error = 1.0;
  for (const int degree : {4, 6, 8, 10}) {
    const model::FaceTables tables(degree, degree, 16, model::Range::whole, false);
    const Face face =
        interpolated_face(tables, [](double u, double v) { return sphere_point(5.0, u, v); });
    const double error = std::abs(energy(face, Energy::bending) - 2.0 * solid_angle);
    EXPECT_LT(error, 0.2 * previous_error);
    EXPECT_NEAR(energy(face, Energy::area), 25.0 * solid_angle, 25.0 * previous_error);
    previous_error = error;
  }
  EXPECT_LT(previous_error, 1e-8);
}

TEST(Shapes, ASphereHasNoCurvatureVariation) {
  const model::FaceTables tables(10, 10, 16, model::Range::whole, false);
  const Face face =
      interpolated_face(tables, [](double u, double v) { return sphere_point(5.0, u, v); });
  EXPECT_LT(energy(face, Energy::variation), 1e-10);
}

TEST(Shapes, ACylinderBendsByItsAngleTimesLengthOverRadius) {
  const model::FaceTables tables(9, 1, 16, model::Range::whole, false);
  const Face face =
      interpolated_face(tables, [](double u, double v) { return cylinder_point(2.0, u, v); });
  EXPECT_NEAR(energy(face, Energy::bending), 3.0 / 2.0, 1e-8);
  EXPECT_NEAR(energy(face, Energy::area), 6.0, 1e-9);
  EXPECT_LT(energy(face, Energy::variation), 1e-8);
}

TEST(Shapes, AParabolicTroughHasTheVariationOfItsProfile) {
  // z = x^2 / 2 over x in [0, 1], y in [0, 1]: k = (1 + x^2)^(-3/2), H = k / 2 up to sign, along
  // the arc dk/ds = -3 x (1 + x^2)^(-3), so the integral is that of 9/4 x^2 (1 + x^2)^(-11/2) over
  // x.
  const model::FaceTables tables(2, 1, 32, model::Range::whole, false);
  const Face face =
      interpolated_face(tables, [](double u, double v) { return Vector3d(u, v, 0.5 * u * u); });
  const model::GaussRule fine = model::gauss_rule(64, 0.0, 1.0);
  double expected = 0.0;
  for (int k = 0; k < 64; ++k) {
    const double x = fine.nodes[k];
    expected += fine.weights[k] * 2.25 * x * x * std::pow(1.0 + x * x, -5.5);
  }
  EXPECT_NEAR(energy(face, Energy::variation), expected, 1e-13);
}

TEST(Shapes, APlaneCostsNothing) {
  const model::FaceTables tables(4, 3, 8, model::Range::whole, false);
  const Face face = interpolated_face(tables, [](double u, double v) {
    return Vector3d(u + 0.2 * u * v, v - 0.1 * u * u,
                    2.0 * (u + 0.2 * u * v) - 3.0 * (v - 0.1 * u * u));
  });
  EXPECT_GT(energy(face, Energy::area), 1.0);
  EXPECT_LT(energy(face, Energy::bending), 1e-25);
  EXPECT_LT(energy(face, Energy::variation), 1e-22);
  EXPECT_EQ(energy(face, Energy::fold), 0.0);
}

TEST(Shapes, CurvatureOfASphereIsOneOverItsRadius) {
  const model::FaceTables tables(10, 10, 8, model::Range::whole, false);
  const Face face =
      interpolated_face(tables, [](double u, double v) { return sphere_point(5.0, u, v); });
  std::vector<double> mean(64), gauss(64);
  best().curvature(tables.rule(), face.net.data(), nullptr, mean.data(), gauss.data());
  for (int k = 0; k < 64; ++k) {
    // Su x Sv points out of the sphere here, and L, M, N count as positive towards the normal.
    EXPECT_NEAR(mean[k], -0.2, 1e-6);
    EXPECT_NEAR(gauss[k], 0.04, 1e-6);
  }
}

TEST(FoldBarrier, IsZeroWithZeroGradientOnAGentlePatch) {
  const model::FaceTables tables(3, 3, 8, model::Range::whole, false);
  const auto [value, gradient] = energy_pullback(best(), wavy_face(tables, 21), Energy::fold);
  EXPECT_EQ(value, 0.0);
  for (const double x : gradient) EXPECT_EQ(x, 0.0);
}

TEST(FoldBarrier, IsPositiveOnAFoldedPatchAndFallsAlongItsGradient) {
  const model::FaceTables tables(3, 3, 8, model::Range::whole, false);
  Face face = wavy_face(tables, 22, 1.0);
  const auto [value, gradient] = energy_pullback(best(), face, Energy::fold);
  EXPECT_GT(value, 1e-2);
  double square = 0.0;
  for (const double x : gradient) square += x * x;
  const double step = 1e-3 * value / square;
  for (std::size_t k = 0; k < face.net.size(); ++k) face.net[k] -= step * gradient[k];
  EXPECT_NEAR(energy(face, Energy::fold), 0.999 * value, 1e-5 * value);
}

TEST(FoldBarrier, GrowsWithTheCosineAskedFor) {
  const model::FaceTables tables(3, 3, 8, model::Range::whole, false);
  const Face face = wavy_face(tables, 22, 1.0);
  double previous = 0.0;
  for (const double cosine : {-0.5, 0.0, 0.5, 0.9}) {
    const double value = best().fold(tables.rule(), face.net.data(), nullptr, {cosine});
    EXPECT_GT(value, previous);
    previous = value;
  }
  EXPECT_LE(previous, 1.0);
}

TEST(FoldBarrier, IsFiniteWherePartOfTheFaceHasNoNormal) {
  const model::FaceTables tables(3, 3, 8, model::Range::whole, false);
  const Face point =
      interpolated_face(tables, [](double, double) { return Vector3d(1.0, 2.0, 3.0); });
  EXPECT_TRUE(std::isfinite(energy(point, Energy::fold)));
}

class Laws : public testing::TestWithParam<bool> {
 protected:
  model::FaceTables tables{5, 3, 8, model::Range::whole, GetParam()};
  Face face = wavy_face(tables, 31, 1.0);

  Face scaled(double factor) {
    Face other = mapped_face(face, [&](const Vector3d& p) { return Vector3d(factor * p); });
    for (double& x : other.blend) x *= factor;
    return other;
  }
};

TEST_P(Laws, ScalingByLengthFollowsTheDimensions) {
  for (const double factor : {1e-4, 0.5, 1000.0}) {
    const Face other = scaled(factor);
    EXPECT_NEAR(energy(other, Energy::area) / energy(face, Energy::area), factor * factor,
                1e-12 * factor * factor);
    EXPECT_NEAR(energy(other, Energy::bending) / energy(face, Energy::bending), 1.0, 1e-12);
    EXPECT_NEAR(
        energy(other, Energy::variation) / energy(face, Energy::variation) * factor * factor, 1.0,
        1e-12);
    EXPECT_NEAR(energy(other, Energy::fold), energy(face, Energy::fold), 1e-12);
  }
}

TEST_P(Laws, RigidMotionsAndMirrorsChangeNothing) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Vector3d(1.0, -2.0, 0.5).normalized()));
  for (const double mirror : {1.0, -1.0}) {
    const auto linear = [&](const Vector3d& p) {
      return turn * Vector3d(p.x(), mirror * p.y(), p.z());
    };
    Face other = mapped_face(
        face, [&](const Vector3d& p) { return Vector3d(linear(p) + Vector3d(3.0, 1.0, -2.0)); });
    const Vector3d blend = linear(Vector3d(face.blend[0], face.blend[1], face.blend[2]));
    other.blend = {blend.x(), blend.y(), blend.z()};
    for (const Energy which : {Energy::area, Energy::bending, Energy::variation, Energy::fold}) {
      const double value = energy(face, which);
      EXPECT_NEAR(energy(other, which), value, 1e-11 * value) << energy_name(which);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutBlend, Laws, testing::Bool());

TEST(Parametrisation, ElevatingTheDegreeChangesNothing) {
  const auto saddle = [](double u, double v) {
    return Vector3d(u + 0.1 * v * v, v - 0.2 * u * u * v,
                    0.4 * u * u * u - 0.3 * v * v * u + 0.1 * v);
  };
  const model::FaceTables low(3, 2, 8, model::Range::whole, false);
  const Face first = interpolated_face(low, saddle);
  for (const auto& [u, v] : {std::pair{3, 3}, {4, 5}, {6, 6}, {8, 7}, {12, 12}}) {
    const model::FaceTables tables(u, v, 8, model::Range::whole, false);
    const Face face = interpolated_face(tables, saddle);
    for (const Energy which : {Energy::area, Energy::bending, Energy::variation}) {
      // Interpolation at degree 12 costs some digits.
      EXPECT_NEAR(energy(face, which), energy(first, which), 1e-9) << energy_name(which);
    }
  }
}

TEST(Parametrisation, SwappingUAndVChangesNothing) {
  const model::FaceTables tables(5, 3, 8, model::Range::whole, false),
      swapped(3, 5, 8, model::Range::whole, false);
  const Face face = wavy_face(tables, 41, 1.0);
  Face other{&swapped, std::vector<double>(face.net.size()), {}};
  for (int i = 0; i <= 5; ++i) {
    for (int j = 0; j <= 3; ++j) {
      for (int c = 0; c < 3; ++c) other.net[(j * 6 + i) * 3 + c] = face.net[(i * 4 + j) * 3 + c];
    }
  }
  for (const Energy which : {Energy::area, Energy::bending, Energy::variation, Energy::fold}) {
    const double value = energy(face, which);
    EXPECT_NEAR(energy(other, which), value, 1e-12 * value) << energy_name(which);
  }
}

TEST(Parametrisation, TheTwoHalvesOfASymmetricFaceCostTheSame) {
  for (const model::Range range : {model::Range::half_u, model::Range::half_v}) {
    const bool along_u = range == model::Range::half_u;
    const auto arch = [&](double u, double v) {
      const double x = (along_u ? u : v) - 0.5, y = along_u ? v : u;
      return Vector3d(x * (1.0 + 0.2 * y), y + x * x * y, 0.3 * x * x * (1.0 + y) - 0.1 * y * y);
    };
    const model::FaceTables whole(4, 4, 24, model::Range::whole, false),
        half(4, 4, 24, range, false);
    for (const Energy which : {Energy::area, Energy::bending, Energy::variation}) {
      const double value = energy(interpolated_face(whole, arch), which);
      EXPECT_NEAR(2.0 * energy(interpolated_face(half, arch), which), value, 1e-10 * value)
          << energy_name(which);
    }
  }
}

}  // namespace
}  // namespace bodyline::test
