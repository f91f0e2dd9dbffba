// A patch over any basis as a Bezier patch (docs/families.md, section 6).

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "model/family.hpp"
#include "model/shaped_net.hpp"
#include "model/surface.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::Surface;
using model::Vec3;

constexpr double rounding_mm = 1e-9;  // of points up to 4 m
constexpr double promised_mm = 1e-6;  // of an H-Bezier patch as a Bezier patch

struct Shape {
  std::string family;
  int m, n;
};

class ShapedPatchOf : public ::testing::TestWithParam<Shape> {
 protected:
  ShapedPatchOf() {
    std::normal_distribution<double> point(0.0, 100.0);
    for (int i = 0; i <= m; ++i) {
      for (int j = 0; j <= n; ++j) {
        const bool inner = i > 0 && i < m && j > 0 && j < n;
        boundary.push_back(inner ? Vec3<double>{}
                                 : Vec3<double>{500.0 * i + point(random),
                                                400.0 * j + point(random), point(random)});
      }
    }
    const model::ShapeCounts counts = model::shape_counts(GetParam().family, m, n);
    shape_u = random_shape(*basis_u, counts.u);
    shape_v = random_shape(*basis_v, counts.v);
  }

  std::vector<double> random_shape(const model::AnyBasis& basis, int count) {
    std::vector<double> shape;
    for (int k = 0; k < count; ++k) {
      const int own = k % basis.shape_count();
      shape.push_back(std::uniform_real_distribution<double>(
          std::max(basis.shape_range(own).lower, basis.body_range(own).lower),
          std::min(basis.shape_range(own).upper, basis.body_range(own).upper))(random));
    }
    return shape;
  }

  model::ShapedPatch plan() const {
    const bool per_row = model::find_family(GetParam().family).shape_per_row;
    return model::ShapedPatch(
        GetParam().family, m, n, std::max(m, basis_u->abscissa_degree()),
        std::max(n, per_row ? basis_v->bezier_degree() : basis_v->abscissa_degree()));
  }

  Surface surface(const model::ShapedPatch& patch) const {
    std::vector<Vec3<double>> net((patch.net_m + 1) * (patch.net_n + 1));
    model::shaped_net(patch, shape_u.data(), shape_v.data(), boundary.data(), net.data());
    Surface result;
    result.degree_u = patch.net_m;
    result.degree_v = patch.net_n;
    for (const Vec3<double>& p : net) result.net.push_back({p.x, p.y, p.z});
    return result;
  }

  Vector3d at(int i, int j) const {
    const Vec3<double>& p = boundary[i * (n + 1) + j];
    return {p.x, p.y, p.z};
  }

  std::span<const double> row(int i) const {
    const bool per_row = model::find_family(GetParam().family).shape_per_row;
    return std::span(shape_v).subspan(per_row ? i * basis_v->shape_count() : 0,
                                      basis_v->shape_count());
  }

  // R1 + R2 - T at (u, v), straight from eqs. (7)-(11).
  Vector3d superposition(double u, double v) const;

  const int m = GetParam().m, n = GetParam().n;
  std::mt19937 random{unsigned(10 * GetParam().m + GetParam().n)};
  std::unique_ptr<const model::AnyBasis> basis_u = model::family(GetParam().family, m),
                                         basis_v = model::family(GetParam().family, n);
  std::vector<Vec3<double>> boundary;
  std::vector<double> shape_u, shape_v;
};
INSTANTIATE_TEST_SUITE_P(Shapes, ShapedPatchOf,
                         ::testing::Values(Shape{"ge-bezier", 3, 4}, Shape{"bezier-like", 2, 2},
                                           Shape{"bezier-like", 3, 3}, Shape{"bezier-like", 5, 3},
                                           Shape{"bezier-like", 2, 9}, Shape{"bezier-like", 9, 4},
                                           Shape{"h-bezier", 3, 3}, Shape{"h-bezier", 5, 3},
                                           Shape{"h-bezier", 9, 9}),
                         [](const auto& at) {
                           std::string name = at.param.family + "_" + std::to_string(at.param.m) +
                                              std::to_string(at.param.n);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

Vector3d ShapedPatchOf::superposition(double u, double v) const {
  const auto coons = [&](int i, int j) -> Vector3d {
    const double a = double(i) / m, b = double(j) / n;
    return (1 - a) * at(0, j) + a * at(m, j) + (1 - b) * at(i, 0) + b * at(i, n) -
           (1 - a) * ((1 - b) * at(0, 0) + b * at(0, n)) - a * ((1 - b) * at(m, 0) + b * at(m, n));
  };
  const auto r1 = [&](double s, double t) {
    const model::BernsteinJet along = model::bernstein(m, s);
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i <= m; ++i) {
      const model::BasisJet across = basis_v->evaluate(t, row(i));
      for (int j = 0; j <= n; ++j) sum += along.d[0][i] * across.d[0][j] * coons(i, j);
    }
    return sum;
  };
  const auto r2 = [&](double s, double t) {
    const model::BernsteinJet along = model::bernstein(n, t);
    const model::BasisJet across = basis_u->evaluate(s, shape_u);
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i <= m; ++i) {
      for (int j = 0; j <= n; ++j) sum += along.d[0][j] * across.d[0][i] * coons(i, j);
    }
    return sum;
  };
  const Vector3d corners =
      (1 - u) * ((1 - v) * at(0, 0) + v * at(0, n)) + u * ((1 - v) * at(m, 0) + v * at(m, n));
  const Vector3d t =
      (1 - u) * r1(0, v) + u * r1(1, v) + (1 - v) * r2(u, 0) + v * r2(u, 1) - corners;
  return r1(u, v) + r2(u, v) - t;
}

TEST_P(ShapedPatchOf, IsTheSuperposition) {
  const Surface form = surface(plan());
  const double tolerance =
      model::find_family(GetParam().family).polynomial ? rounding_mm : promised_mm;
  for (const double u : {0.0, 0.13, 0.5, 0.81, 1.0}) {
    for (const double v : {0.0, 0.22, 0.6, 0.97, 1.0})
      EXPECT_LE((model::jet(form, u, v, 0).d[0] - superposition(u, v)).norm(), tolerance);
  }
}

TEST_P(ShapedPatchOf, PassesThroughItsCurves) {
  const Surface form = surface(plan());
  const auto curve = [&](const std::function<Vector3d(int)>& point, int degree, double t) {
    const model::BernsteinJet bernstein = model::bernstein(degree, t);
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k <= degree; ++k) sum += bernstein.d[0][k] * point(k);
    return sum;
  };
  for (const double t : {0.0, 0.3, 0.7, 1.0}) {
    const auto expect = [&](double u, double v, const Vector3d& expected) {
      EXPECT_LE((model::jet(form, u, v, 0).d[0] - expected).norm(), rounding_mm);
    };
    expect(t, 0, curve([&](int k) { return at(k, 0); }, m, t));
    expect(t, 1, curve([&](int k) { return at(k, n); }, m, t));
    expect(0, t, curve([&](int k) { return at(0, k); }, n, t));
    expect(1, t, curve([&](int k) { return at(m, k); }, n, t));
  }
}

TEST_P(ShapedPatchOf, BoundaryNeverMovesWithShape) {
  const Surface before = surface(plan());
  shape_u = random_shape(*basis_u, int(shape_u.size()));
  shape_v = random_shape(*basis_v, int(shape_v.size()));
  const Surface after = surface(plan());
  double moved = 0.0;
  for (int i = 0; i <= before.degree_u; ++i) {
    for (int j = 0; j <= before.degree_v; ++j) {
      const bool inner = i > 0 && i < before.degree_u && j > 0 && j < before.degree_v;
      if (inner) {
        moved = std::max(moved, (before.point(i, j) - after.point(i, j)).norm());
      } else {
        EXPECT_EQ(before.point(i, j), after.point(i, j));
      }
    }
  }
  EXPECT_GT(moved, 0.01);
}

TEST_P(ShapedPatchOf, KeepsItsShapeWhenItIsRaised) {
  const Surface own = surface(plan());
  const model::ShapedPatch higher(GetParam().family, m, n, 11, 11);
  const Surface raised = surface(higher);
  for (const double u : {0.1, 0.6}) {
    for (const double v : {0.3, 0.9})
      EXPECT_LE((model::jet(own, u, v, 0).d[0] - model::jet(raised, u, v, 0).d[0]).norm(),
                rounding_mm);
  }
}

// With one gamma for all rows a cubic Bezier-like patch is the GE-Bezier patch whose shape values
// differ by 2 gamma from those of the plain Coons patch.
TEST(ShapedPatch, UniformCubicBezierLikeIsGeBezier) {
  std::mt19937 random(8);
  std::normal_distribution<double> point(0.0, 100.0);
  std::vector<Vec3<double>> boundary;
  for (int k = 0; k < 16; ++k)
    boundary.push_back({100.0 * (k / 4) + point(random), 100.0 * (k % 4), point(random)});
  const double lambda = 0.7, gamma = -0.4;
  const model::ShapedPatch like("bezier-like", 3, 3, 5, 5), ge("ge-bezier", 3, 3, 5, 5);
  const std::vector<double> gammas(4, gamma), ge_u{1 + 2 * lambda, 1 + 2 * lambda},
      ge_v{1 + 2 * gamma, 1 + 2 * gamma};
  std::vector<Vec3<double>> a(36), b(36);
  model::shaped_net(like, &lambda, gammas.data(), boundary.data(), a.data());
  model::shaped_net(ge, ge_u.data(), ge_v.data(), boundary.data(), b.data());
  for (int k = 0; k < 36; ++k) {
    EXPECT_NEAR(a[k].x, b[k].x, rounding_mm);
    EXPECT_NEAR(a[k].y, b[k].y, rounding_mm);
    EXPECT_NEAR(a[k].z, b[k].z, rounding_mm);
  }
}

}  // namespace
}  // namespace bodyline::testing
