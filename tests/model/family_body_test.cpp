// Patches of any family in a body (docs/families.md, section 6).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check_models.hpp"
#include "model/build.hpp"
#include "model/check_findings.hpp"
#include "model/family.hpp"
#include "model/shaped_net.hpp"
#include "model/variables.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::Surface;
using model::Vec3;

constexpr double rounding_mm = 1e-9;  // of points up to 4 m
constexpr double promised_mm = 1e-6;  // of an H-Bezier patch as a Bezier patch
constexpr double edge_mm = 1e-9, edge_deg = 1e-6;

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

TEST(FamilyBody, NetsHaveTheDegreesThatTheirFamiliesNeed) {
  std::mt19937 random(9);
  const model::Model car = car_of_families("model2", random);
  const model::Connectivity links = model::connect(car);
  const auto degrees = [&](const std::string& name) {
    for (std::size_t p = 0; p < car.patches.size(); ++p) {
      if (car.patches[p].name == name)
        return std::pair(links.patches[p].net_degree_u, links.patches[p].net_degree_v);
    }
    return std::pair(0, 0);
  };
  EXPECT_EQ(degrees("roof"), std::pair(5, 5));
  EXPECT_EQ(degrees("windshield"), std::pair(11, 11));
  EXPECT_EQ(degrees("hood"), std::pair(3, 3));
  // Both seams of the door run along v or u of their patches, which are raised with it.
  EXPECT_EQ(degrees("door_upper"), std::pair(3, 7));
  EXPECT_EQ(degrees("front_fender_upper"), std::pair(3, 3));
}

TEST(FamilyBody, OrdinaryBodiesHaveNoShapedPatch) {
  for (const char* name : car_names) {
    for (const model::PatchStep& step : model::plan_body(load_car(name)).patches)
      EXPECT_FALSE(step.shaped);
  }
}

// Everything joins as exactly as in a body of one family.
class FamilyBodyOf : public ::testing::TestWithParam<std::string> {
 protected:
  model::Model car() const {
    std::mt19937 random(10);
    if (GetParam() == "mixed") return car_of_families("model2", random);
    model::Model result = load_car("model2");
    for (const model::Patch& patch : load_car("model2").patches)
      set_family(result, patch.name, GetParam(), random);
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(Families, FamilyBodyOf,
                         ::testing::Values("mixed", "bezier-like", "h-bezier"), [](const auto& at) {
                           std::string name = at.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(FamilyBodyOf, IsClosedAndSmoothAtEveryEdge) {
  const model::BodyCheck check = model::check_body(car());
  int edges = 0;
  for (const model::EdgeCheck& edge : check.edges) {
    if (edge.stage == model::Stage::base) continue;
    EXPECT_LE(edge.deviation.gap_mm, edge_mm) << edge.name;
    EXPECT_LE(edge.deviation.normal_deviation_deg, edge.pillar ? 0.01 : edge_deg) << edge.name;
    ++edges;
  }
  EXPECT_GT(edges, 30);
}

TEST_P(FamilyBodyOf, IsMirrorSymmetric) {
  for (const Surface& face : model::build(car(), model::Stage::base)) {
    if (!face.central) continue;
    for (const double u : {0.2, 0.7}) {
      for (const double v : {0.1, 0.4}) {
        const Vector3d left = model::jet(face, u, v, 0).d[0],
                       right = model::jet(face, u, 1.0 - v, 0).d[0];
        EXPECT_LE((Vector3d(left.x(), -left.y(), left.z()) - right).norm(), rounding_mm);
      }
    }
  }
}

TEST(FamilyBody, VariablesOfAFamilyHaveItsNamesBoundsAndTies) {
  std::mt19937 random(12);
  model::Model car = load_car("template");
  set_family(car, "roof", "bezier-like", random);
  set_family(car, "hood", "h-bezier", random);
  const model::VariableMap map(car, model::connect(car));
  const auto find = [&](const std::string& name) -> const model::Variable& {
    for (const model::Variable& variable : map.variables()) {
      if (variable.name == name) return variable;
    }
    throw std::out_of_range(name);
  };
  EXPECT_EQ(find("shape.roof.u[0]").lower, -1.0);
  EXPECT_EQ(find("shape.roof.v[5]").upper, 1.0);
  EXPECT_EQ(find("shape.roof.v[5]").ties.size(), 1u);
  EXPECT_EQ(find("shape.hood.u[2]").lower, 0.0);
  EXPECT_EQ(find("shape.hood.u[2]").upper, 4.0);
  // beta_1 and beta_3 of a patch across the middle are one.
  EXPECT_EQ(find("shape.hood.v[0]").ties.size(), 2u);
  EXPECT_EQ(find("shape.hood.v[1]").ties.size(), 1u);
}

struct Broken {
  const char* name;
  void (*spoil)(model::Patch&);
  const char* key;
  const char* words;
};

class FamilyBodyRefuses : public ::testing::TestWithParam<Broken> {};
INSTANTIATE_TEST_SUITE_P(
    Patches, FamilyBodyRefuses,
    ::testing::Values(Broken{"unknown", [](model::Patch& p) { p.basis = "bezier"; },
                             "patches.hood.basis", "known are ge-bezier, bezier-like, h-bezier"},
                      Broken{"too_few",
                             [](model::Patch& p) {
                               p.basis = "bezier-like";
                               p.shape_u = {0.0};
                               p.shape_v = {0.0};
                             },
                             "patches.hood.shape.v", "has 4"},
                      Broken{"out_of_range",
                             [](model::Patch& p) {
                               p.basis = "bezier-like";
                               p.shape_u = {1.25};
                               p.shape_v = {0.0, 0.0, 0.0, 0.0};
                             },
                             "patches.hood.shape.u[0]", "from -1 to 1"},
                      Broken{"too_tense",
                             [](model::Patch& p) {
                               p.basis = "h-bezier";
                               p.shape_u = {1.0, 5.0, 1.0};
                               p.shape_v = {1.0, 1.0, 1.0};
                             },
                             "patches.hood.shape.u[1]", "from 0 to 4"},
                      Broken{"not_symmetric",
                             [](model::Patch& p) {
                               p.basis = "h-bezier";
                               p.shape_u = {1.0, 2.0, 3.0};
                               p.shape_v = {1.0, 1.0, 2.0};
                             },
                             "patches.hood.shape.v", "value 0 is 1, value 2 is 2"}),
    [](const auto& at) { return at.param.name; });

TEST_P(FamilyBodyRefuses, WithTheKeyAndWhatIsAllowed) {
  model::Model car = load_car("template");
  for (model::Patch& patch : car.patches) {
    if (patch.name == "hood") GetParam().spoil(patch);
  }
  try {
    model::connect(car);
    FAIL();
  } catch (const model::ModelError& error) {
    EXPECT_EQ(error.key(), GetParam().key);
    EXPECT_THAT(error.what(), ::testing::HasSubstr(GetParam().words));
  }
}

TEST(FamilyBodyRefuses, DegreesThatAFamilyDoesNotHave) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    model::Model box = random_box(random);
    for (model::Patch& patch : box.patches) {
      if (model::side_degree(box, patch, model::Side::v0) != 2) continue;
      patch.basis = "h-bezier";
      EXPECT_THROW(model::connect(box), model::ModelError);
      return;
    }
  }
  FAIL() << "no box has a patch of degree 2";
}

}  // namespace
}  // namespace bodyline::testing
