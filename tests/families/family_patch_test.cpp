// Patches of a family by themselves (docs/families.md, sections 2 and 3).

#include "model/family_patch.hpp"

#include <gtest/gtest.h>

#include "golden.hpp"
#include "model/bezier_form.hpp"
#include "model/bezier_pieces.hpp"
#include "model/family.hpp"
#include "sample_patches.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::FamilyPatch;

// Sums of 36 products of coordinates up to 1000 mm with numbers up to 100.
constexpr double rounding_mm = 1e-9;

FamilyPatch golden_patch() {
  const nlohmann::json json = golden("bezier_like_patch");
  FamilyPatch patch;
  patch.degree_u = 2;
  patch.degree_v = 3;
  for (const auto& row : json["P"]) {
    for (const auto& point : row) patch.points.push_back(golden_point(point));
  }
  patch.shape_u = {json["lam"]};
  patch.shape_v = json["gam"].get<std::vector<double>>();
  return patch;
}

TEST(FamilyPatch, BezierLikeJetAgreesWithGoldenNumbers) {
  const nlohmann::json json = golden("bezier_like_patch");
  const model::SurfaceJet at = model::jet(golden_patch(), json["u"], json["v"]);
  const char* const keys[] = {"S", "Su", "Sv", "Suu", "Suv", "Svv"};
  for (int q = 0; q < 6; ++q)
    EXPECT_LE((at.d[q] - golden_point(json[keys[q]])).norm(), 100.0 * golden_tolerance) << keys[q];
}

TEST(FamilyPatch, BezierLikeNetAgreesWithGoldenNumbers) {
  const nlohmann::json net = golden("bezier_like_patch")["bezier"];
  const model::Surface surface = model::bezier_form(golden_patch());
  ASSERT_EQ(surface.degree_u, 4);
  ASSERT_EQ(surface.degree_v, 5);
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 5; ++j)
      EXPECT_LE((surface.point(i, j) - golden_point(net[i][j])).norm(), 100.0 * golden_tolerance);
  }
}

struct Kind {
  std::string family;
  int degree_u, degree_v;
};

class FamilyPatchOf : public ::testing::TestWithParam<Kind> {
 protected:
  std::mt19937 random{11};
  FamilyPatch patch = random_patch(GetParam().family, GetParam().degree_u, GetParam().degree_v,
                                   Vector3d::Zero(), random);
};
INSTANTIATE_TEST_SUITE_P(Kinds, FamilyPatchOf,
                         ::testing::Values(Kind{"bezier-like", 3, 3}, Kind{"bezier-like", 2, 5},
                                           Kind{"bezier-like", 9, 4}, Kind{"h-bezier", 3, 3},
                                           Kind{"h-bezier", 5, 3}, Kind{"ge-bezier", 4, 3}),
                         [](const auto& at) {
                           std::string name = at.param.family + std::to_string(at.param.degree_u) +
                                              std::to_string(at.param.degree_v);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(FamilyPatchOf, PassesThroughItsCorners) {
  const int m = patch.degree_u, n = patch.degree_v;
  EXPECT_LE((model::jet(patch, 0, 0).d[0] - patch.point(0, 0)).norm(), rounding_mm);
  EXPECT_LE((model::jet(patch, 1, 0).d[0] - patch.point(m, 0)).norm(), rounding_mm);
  EXPECT_LE((model::jet(patch, 0, 1).d[0] - patch.point(0, n)).norm(), rounding_mm);
  EXPECT_LE((model::jet(patch, 1, 1).d[0] - patch.point(m, n)).norm(), rounding_mm);
}

TEST_P(FamilyPatchOf, PiecesAgreeWithinTheTolerance) {
  const double tolerance_mm = 1e-4;
  const bool exact = model::find_family(patch.family).polynomial;
  const std::vector<model::Surface> pieces =
      model::bezier_pieces(patch, tolerance_mm, model::control_size(patch.points));
  if (exact) {
    ASSERT_EQ(pieces.size(), 1u);
    for (const double u : {0.0, 0.31, 1.0}) {
      for (const double v : {0.0, 0.77, 1.0}) {
        const model::SurfaceJet form = model::jet(pieces[0], u, v, 3),
                                own = model::jet(patch, u, v);
        for (int q = 0; q < 10; ++q)
          EXPECT_LE((form.d[q] - own.d[q]).norm(), rounding_mm * (1.0 + own.d[q].norm()));
      }
    }
    return;
  }
  EXPECT_GT(pieces.size(), 1u);
  // Where a piece lies follows from the breaks that both directions have.
  const double tolerance = 0.5 * tolerance_mm / model::control_size(patch.points);
  const auto breaks_u =
      model::bezier_breaks(*model::family(patch.family, patch.degree_u), patch.shape_u, tolerance);
  const auto breaks_v =
      model::bezier_breaks(*model::family(patch.family, patch.degree_v), patch.shape_v, tolerance);
  ASSERT_EQ(pieces.size(), (breaks_u.size() - 1) * (breaks_v.size() - 1));
  std::size_t k = 0;
  for (std::size_t a = 0; a + 1 < breaks_u.size(); ++a) {
    for (std::size_t b = 0; b + 1 < breaks_v.size(); ++b, ++k) {
      for (int sample = 0; sample < 100; ++sample) {
        const double s = (sample % 10) / 9.0, t = (sample / 10) / 9.0;
        const double u = breaks_u[a] + s * (breaks_u[a + 1] - breaks_u[a]);
        const double v = breaks_v[b] + t * (breaks_v[b + 1] - breaks_v[b]);
        EXPECT_LE((model::jet(pieces[k], s, t, 0).d[0] - model::jet(patch, u, v).d[0]).norm(),
                  tolerance_mm);
      }
    }
  }
}

TEST_P(FamilyPatchOf, BezierFormPullbackIsTheDerivative) {
  if (patch.family == "h-bezier") {
    for (double& alpha : patch.shape_u) alpha *= 0.6;
  }
  const model::Surface form = model::bezier_form(patch);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Vector3d> net_bar;
  for (std::size_t k = 0; k < form.net.size(); ++k)
    net_bar.push_back({unit(random), unit(random), unit(random)});
  const auto value = [&](const FamilyPatch& at) {
    const model::Surface surface = model::bezier_form(at);
    double sum = 0.0;
    for (std::size_t k = 0; k < net_bar.size(); ++k) sum += surface.net[k].dot(net_bar[k]);
    return sum;
  };
  model::FamilyPatchBar bar(patch);
  model::bezier_form_pullback(patch, net_bar, bar);
  const auto expect = [&](double& number, double step, double actual) {
    const double kept = number;
    const double size = std::abs(kept) > 0.5 ? -step : step;  // inwards of every range
    number = kept + size;
    const double one = value(patch);
    number = kept + 2.0 * size;
    const double two = value(patch);
    number = kept;
    // Second order in the step: (4 f1 - f2 - 3 f0) / 2h.
    const double slope = (4.0 * one - two - 3.0 * value(patch)) / (2.0 * size);
    EXPECT_NEAR(actual, slope, 1e-5 * (1.0 + std::abs(slope)));
    EXPECT_NE(actual, 0.0);
  };
  for (std::size_t k = 0; k < patch.shape_u.size(); ++k)
    expect(patch.shape_u[k], 1e-4, bar.shape_u[k]);
  for (std::size_t k = 0; k < patch.shape_v.size(); ++k)
    expect(patch.shape_v[k], 1e-4, bar.shape_v[k]);
  for (std::size_t k = 0; k < patch.points.size(); ++k)
    expect(patch.points[k].y(), 1.0, bar.points[k].y());
}

// Which boundary moves: Propositions 1(b) and 2(b) of Hu et al.
TEST(FamilyPatch, LambdaMovesOnlyTheSidesAlongU) {
  std::mt19937 random(3);
  FamilyPatch patch = random_patch("bezier-like", 4, 3, Vector3d::Zero(), random);
  FamilyPatch moved = patch;
  moved.shape_u[0] = patch.shape_u[0] > 0.0 ? -0.5 : 0.5;
  for (const double t : {0.3, 0.8}) {
    EXPECT_EQ(model::jet(patch, 0, t).d[0], model::jet(moved, 0, t).d[0]);
    EXPECT_LE((model::jet(patch, 1, t).d[0] - model::jet(moved, 1, t).d[0]).norm(), rounding_mm);
    EXPECT_GT((model::jet(patch, t, 0).d[0] - model::jet(moved, t, 0).d[0]).norm(), 0.1);
  }
}

TEST(FamilyPatch, InnerGammasMoveNoBoundary) {
  std::mt19937 random(4);
  const FamilyPatch patch = random_patch("bezier-like", 4, 3, Vector3d::Zero(), random);
  FamilyPatch moved = patch;
  for (int i = 1; i < 4; ++i) moved.shape_v[i] = patch.shape_v[i] > 0.0 ? -0.5 : 0.5;
  for (const double t : {0.0, 0.3, 0.8}) {
    for (const double end : {0.0, 1.0}) {
      EXPECT_LE((model::jet(patch, end, t).d[0] - model::jet(moved, end, t).d[0]).norm(),
                rounding_mm);
      EXPECT_LE((model::jet(patch, t, end).d[0] - model::jet(moved, t, end).d[0]).norm(),
                rounding_mm);
    }
  }
  EXPECT_GT((model::jet(patch, 0.5, 0.3).d[0] - model::jet(moved, 0.5, 0.3).d[0]).norm(), 0.1);
}

TEST(FamilyPatch, RefusesWrongCountsAndRanges) {
  std::mt19937 random(5);
  const FamilyPatch good = random_patch("bezier-like", 3, 3, Vector3d::Zero(), random);
  const auto expect_refused = [&](const std::function<void(FamilyPatch&)>& spoil) {
    FamilyPatch bad = good;
    spoil(bad);
    EXPECT_THROW(model::check_patch(bad), std::invalid_argument);
  };
  EXPECT_NO_THROW(model::check_patch(good));
  expect_refused([](FamilyPatch& p) { p.family = "bezier"; });
  expect_refused([](FamilyPatch& p) { p.points.pop_back(); });
  expect_refused([](FamilyPatch& p) { p.shape_v.push_back(0.0); });
  expect_refused([](FamilyPatch& p) { p.shape_u[0] = 1.5; });
  expect_refused([](FamilyPatch& p) { p.points[3].x() = std::nan(""); });
  expect_refused([](FamilyPatch& p) { p.degree_u = 1; });
}

}  // namespace
}  // namespace bodyline::testing
