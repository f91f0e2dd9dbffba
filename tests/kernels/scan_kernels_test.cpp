// Foot points on one face and the moments of what pulls there, against their definitions.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "model/surface.hpp"
#include "tests/kernels/faces.hpp"

namespace bodyline::test {
namespace {

using Eigen::Vector3d;

constexpr double rounding = 1e-12;  // of numbers of size 1, through sums of a few hundred terms
// Newton doubles the digits at each step: what six leave of a start 0.05 off is rounding.
constexpr int newton_steps = 6;
constexpr int point_count = 77;  // several groups, and one that is not whole

/// Columns of numbers with room for whole groups of 8.
struct Columns {
  explicit Columns(int width) : numbers(std::size_t(width) * padded, 0.25) {}
  static constexpr int padded = (point_count + 7) / 8 * 8;
  double* operator[](int k) { return numbers.data() + k * padded; }
  std::vector<double> numbers;
};

class ScanKernels : public testing::TestWithParam<std::tuple<std::pair<int, int>, bool>> {
 protected:
  ScanKernels() {
    surface.degree_u = degree_u;
    surface.degree_v = degree_v;
    for (std::size_t k = 0; k < face.net.size(); k += 3)
      surface.net.push_back({face.net[k], face.net[k + 1], face.net[k + 2]});
    if (blended) surface.blend = Vector3d(face.blend[0], face.blend[1], face.blend[2]);
    std::mt19937 random(3);
    for (int k = 0; k < 14 * Columns::padded; ++k)
      columns.numbers[k] = double(random()) / double(std::mt19937::max());
  }

  const double* blend() const { return blended ? face.blend.data() : nullptr; }
  int point_size() const { return (degree_u + 1) * (degree_v + 1); }

  model::FootPointArrays foot_arrays() {
    model::FootPointArrays a;
    a.count = point_count;
    a.x = columns[0], a.y = columns[1], a.z = columns[2], a.u = columns[3], a.v = columns[4];
    for (int c = 0; c < 3; ++c) a.foot[c] = columns[5 + c], a.normal[c] = columns[8 + c];
    return a;
  }

  model::PullArrays pull_arrays() {
    model::PullArrays a;
    a.count = point_count;
    a.u = columns[3], a.v = columns[4];
    for (int e = 0; e < 6; ++e) a.weight[e] = columns[5 + e];
    for (int c = 0; c < 3; ++c) a.weighted_target[c] = columns[11 + c];
    for (int k = point_count; k < Columns::padded; ++k)
      for (int c = 5; c < 14; ++c) columns[c][k] = 0.0;
    return a;
  }

  int degree_u = std::get<0>(GetParam()).first, degree_v = std::get<0>(GetParam()).second;
  bool blended = std::get<1>(GetParam());
  model::FaceTables tables{degree_u, degree_v, 8, model::Range::whole, blended};
  Face face = wavy_face(tables, 21);
  model::Surface surface;
  Columns columns{14};
};

std::string case_name(const testing::TestParamInfo<std::tuple<std::pair<int, int>, bool>>& i) {
  const auto& [degrees, blended] = i.param;
  return "degree_" + std::to_string(degrees.first) + "_" + std::to_string(degrees.second) +
         (blended ? "_blended" : "");
}

INSTANTIATE_TEST_SUITE_P(Degrees, ScanKernels,
                         testing::Combine(testing::ValuesIn(tested_degrees()), testing::Bool()),
                         case_name);

TEST_P(ScanKernels, FeetAndNormalsAreThoseOfTheSurface) {
  for (const model::Isa isa : available_sets()) {
    const model::FootPointArrays a = foot_arrays();
    model::kernels(isa).foot_points(degree_u, degree_v, face.net.data(), blend(), 0, a);
    for (int k = 0; k < point_count; ++k) {
      const model::SurfaceJet jet = model::jet(surface, a.u[k], a.v[k], 1);
      const Vector3d normal = jet.d[1].cross(jet.d[2]).normalized();
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(a.foot[c][k], jet.d[0][c], rounding) << isa_text(isa);
        ASSERT_NEAR(a.normal[c][k], normal[c], 100.0 * rounding) << isa_text(isa);
      }
    }
  }
}

TEST_P(ScanKernels, NewtonFindsWhereAPointOffTheSurfaceWasPut) {
  constexpr double off = 1e-3, found = 1e-9;  // in units of the face's size
  for (const model::Isa isa : available_sets()) {
    const model::FootPointArrays a = foot_arrays();
    std::vector<std::array<double, 2>> expected;
    for (int k = 0; k < point_count; ++k) {
      const double u = 0.2 + 0.6 * a.u[k], v = 0.2 + 0.6 * a.v[k];
      const Vector3d point =
          model::jet(surface, u, v, 0).d[0] + off * model::outward_normal(surface, u, v);
      for (int c = 0; c < 3; ++c) columns[c][k] = point[c];
      expected.push_back({u, v});
      a.u[k] = u + 0.02;
      a.v[k] = v - 0.02;
    }
    model::kernels(isa).foot_points(degree_u, degree_v, face.net.data(), blend(), newton_steps, a);
    for (int k = 0; k < point_count; ++k) {
      ASSERT_NEAR(a.u[k], expected[k][0], found) << isa_text(isa);
      ASSERT_NEAR(a.v[k], expected[k][1], found) << isa_text(isa);
    }
  }
}

double binomial(int n, int k) {
  return std::round(std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)));
}

double bernstein(int degree, int k, double t) {
  return binomial(degree, k) * std::pow(t, k) * std::pow(1.0 - t, degree - k);
}

TEST_P(ScanKernels, MomentsAreTheSumsOfTheirDefinition) {
  const int rows = 2 * degree_u + 1, stride = model::moment_stride(degree_v),
            width = model::moment_width(degree_v);
  for (const model::Isa isa : available_sets()) {
    const model::PullArrays pulls = pull_arrays();
    std::vector<double> second(std::size_t(rows) * stride, 0.5), first(3 * point_size(), 0.5);
    model::kernels(isa).add_moments(degree_u, degree_v, pulls, second.data(), first.data());
    for (int a = 0; a < rows; ++a) {
      for (int b = 0; b <= 2 * degree_v; ++b) {
        double expected[6] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
        for (int k = 0; k < point_count; ++k) {
          const double basis =
              bernstein(2 * degree_u, a, pulls.u[k]) * bernstein(2 * degree_v, b, pulls.v[k]);
          for (int e = 0; e < 6; ++e) expected[e] += basis * pulls.weight[e][k];
        }
        for (int e = 0; e < 6; ++e)
          ASSERT_NEAR(second[a * stride + e * width + b], expected[e], 10.0 * rounding)
              << isa_text(isa) << a << ", " << b;
      }
    }
    for (int p = 0; p < point_size(); ++p) {
      double expected[3] = {0.5, 0.5, 0.5};
      for (int k = 0; k < point_count; ++k) {
        const double basis = bernstein(degree_u, p / (degree_v + 1), pulls.u[k]) *
                             bernstein(degree_v, p % (degree_v + 1), pulls.v[k]);
        for (int c = 0; c < 3; ++c) expected[c] += basis * pulls.weighted_target[c][k];
      }
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(first[3 * p + c], expected[c], 10.0 * rounding);
    }
  }
}

}  // namespace
}  // namespace bodyline::test
