#include "model/face_rule.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"
#include "model/surface.hpp"
#include "tests/kernels/dual.hpp"

namespace bodyline::test {
namespace {

TEST(GaussRule, IntegratesPolynomialsOfDegreeTwiceTheNodesLessOne) {
  for (const int nodes : {1, 2, 3, 8, 16, 24, 64}) {
    const model::GaussRule rule = model::gauss_rule(nodes, 0.0, 1.0);
    for (int power = 0; power < 2 * nodes; ++power) {
      double integral = 0.0;
      for (int k = 0; k < nodes; ++k) integral += rule.weights[k] * std::pow(rule.nodes[k], power);
      // Each node's rounding error is magnified by the power.
      EXPECT_NEAR(integral * (power + 1), 1.0, 1e-15 * (4 + power))
          << nodes << " nodes, power " << power;
    }
  }
}

TEST(GaussRule, DoesNotIntegrateOneDegreeMore) {
  const model::GaussRule rule = model::gauss_rule(3, 0.0, 1.0);
  double integral = 0.0;
  for (int k = 0; k < 3; ++k) integral += rule.weights[k] * std::pow(rule.nodes[k], 6);
  EXPECT_GT(std::abs(integral * 7 - 1.0), 1e-4);
}

TEST(GaussRule, RisesInsideItsRangeAndItsWeightsSumToTheLength) {
  const model::GaussRule rule = model::gauss_rule(16, -1.0, 2.5);
  EXPECT_GT(rule.nodes.front(), -1.0);
  EXPECT_LT(rule.nodes.back(), 2.5);
  EXPECT_TRUE(std::is_sorted(rule.nodes.begin(), rule.nodes.end()));
  EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 3.5, 1e-14);
}

TEST(LobattoRule, IntegratesPolynomialsOfDegreeTwiceTheNodesLessThree) {
  for (const int nodes : {2, 3, 5, 8, 16}) {
    const model::GaussRule rule = model::lobatto_rule(nodes, 0.0, 1.0);
    EXPECT_EQ(rule.nodes.front(), 0.0);
    EXPECT_EQ(rule.nodes.back(), 1.0);
    for (int power = 0; power < 2 * nodes - 2; ++power) {
      double integral = 0.0;
      for (int k = 0; k < nodes; ++k) integral += rule.weights[k] * std::pow(rule.nodes[k], power);
      EXPECT_NEAR(integral * (power + 1), 1.0, 1e-15 * (4 + power))
          << nodes << " nodes, power " << power;
    }
  }
}

TEST(FaceTables, HoldTheBernsteinPolynomialsAtTheNodes) {
  const model::FaceTables tables(5, 3, 8, model::Range::half_v, false);
  const model::FaceRule& rule = tables.rule();
  for (int k = 0; k < 8; ++k) {
    EXPECT_LT(tables.rule_v().nodes[k], 0.5);
    const model::BernsteinJet u = model::bernstein(5, tables.rule_u().nodes[k]);
    const model::BernsteinJet v = model::bernstein(3, tables.rule_v().nodes[k]);
    for (int order = 0; order < 4; ++order) {
      for (int i = 0; i <= 5; ++i) EXPECT_EQ(rule.basis_u[(order * 6 + i) * 8 + k], u.d[order][i]);
      for (int j = 0; j <= 3; ++j) EXPECT_EQ(rule.basis_v[(order * 4 + j) * 8 + k], v.d[order][j]);
    }
  }
  EXPECT_NEAR(std::accumulate(rule.weights_v, rule.weights_v + 8, 0.0), 0.5, 1e-15);
  EXPECT_EQ(rule.blend, nullptr);
}

TEST(FaceTables, HoldTheGregoryFunctionAtTheNodes) {
  const model::FaceTables tables(6, 6, 16, model::Range::whole, true);
  for (int kv = 0; kv < 16; ++kv) {
    for (int ku = 0; ku < 16; ++ku) {
      const auto g = model::blend_jet(tables.rule_u().nodes[ku], tables.rule_v().nodes[kv]);
      for (int q = 0; q < 10; ++q) EXPECT_EQ(tables.rule().blend[(q * 16 + kv) * 16 + ku], g[q]);
    }
  }
}

TEST(FaceTables, AreAlignedForTheWidestVectors) {
  for (int degree = 1; degree <= 12; ++degree) {
    const model::FaceTables tables(degree, 3, 8, model::Range::whole, true);
    const model::FaceRule& rule = tables.rule();
    for (const double* table :
         {rule.basis_u, rule.basis_v, rule.weights_u, rule.weights_v, rule.blend}) {
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(table) % 64, 0u);
    }
  }
}

TEST(FaceTables, RefuseWhatTheKernelsCannotTake) {
  using model::FaceTables;
  using model::Range;
  for (const int nodes : {0, 7, 12, 72, -8}) {
    EXPECT_THROW(FaceTables(3, 3, nodes, Range::whole, false), std::invalid_argument) << nodes;
  }
  EXPECT_THROW(FaceTables(0, 3, 8, Range::whole, false), std::invalid_argument);
  EXPECT_THROW(FaceTables(3, 13, 8, Range::whole, false), std::invalid_argument);
}

using Dual1 = Dual<double>;
using Dual2 = Dual<Dual1>;
using Dual3 = Dual<Dual2>;

Dual3 gregory(double u0, double v0) {
  const Dual3 u{Dual2{Dual1{u0, 1.0, 0.0}, Dual1{1.0}, Dual1{0.0}}, Dual2{Dual1{1.0}},
                Dual2{Dual1{0.0}}};
  const Dual3 v{Dual2{Dual1{v0, 0.0, 1.0}, Dual1{0.0}, Dual1{1.0}}, Dual2{Dual1{0.0}},
                Dual2{Dual1{1.0}}};
  const Dual3 one{Dual2{Dual1{1.0}}};
  const Dual3 bump = u * (one - u) * (one - u) * v * (one - v) * (one - v);
  return bump * (u * u - v * v) / (u * u + v * v);
}

TEST(BlendJet, IsTheJetOfItsFormula) {
  for (const double u : {0.02, 0.3, 0.5, 0.98, 1.0}) {
    for (const double v : {0.0, 0.02, 0.3, 0.7, 1.0}) {
      const auto jet = model::blend_jet(u, v);
      const Dual3 g = gregory(u, v);
      // Third derivatives grow like 1 / (distance from the corner).
      const double rounding = 1e-12;
      EXPECT_NEAR(jet[0], g.value.value.value, rounding);
      for (int p = 0; p < 2; ++p) {
        EXPECT_NEAR(jet[1 + p], g.slope[p].value.value, rounding);
        for (int q = 0; q < 2; ++q) {
          EXPECT_NEAR(jet[3 + p + q], g.slope[p].slope[q].value, rounding);
          for (int r = 0; r < 2; ++r)
            EXPECT_NEAR(jet[6 + p + q + r], g.slope[p].slope[q].slope[r], 100 * rounding);
        }
      }
    }
  }
}

TEST(BlendJet, IsZeroAtItsCorner) {
  for (const double x : model::blend_jet(0.0, 0.0)) EXPECT_EQ(x, 0.0);
  for (const double x : model::blend_jet(1e-200, 1e-300)) EXPECT_EQ(x, 0.0);
}

}  // namespace
}  // namespace bodyline::test
