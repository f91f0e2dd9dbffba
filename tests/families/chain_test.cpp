// Chains of joined patches and curves, and what may change in them (docs/families.md, section 4).

#include <gtest/gtest.h>

#include "model/chain_variables.hpp"
#include "model/curve_chain.hpp"
#include "model/join_measure.hpp"
#include "sample_patches.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::ChainKind;
using model::ChainVariable;
using model::JoinMeasure;
using model::PatchChain;

constexpr double normal_deg = 1e-10;
constexpr double tensor_relative = 1e-12;
// Propagation multiplies rounding by the ratios of the joins.
constexpr double growth = 100.0;

bool holds(const PatchChain& chain, double tolerance) {
  for (std::size_t k = 0; k < chain.joins.size(); ++k) {
    const JoinMeasure measure =
        model::measure_join(chain.patches[k], chain.joins[k].direction, chain.patches[k + 1]);
    if (measure.gap_mm > tolerance * 1000.0) return false;
    if (measure.direction_deg > tolerance * 60.0) return false;
    if (chain.joins[k].continuity == 2 &&
        measure.curvature_jump_per_mm > tolerance * measure.curvature_per_mm)
      return false;
  }
  return true;
}

struct Case {
  std::string family;
  int continuity;
};

class Chain : public ::testing::TestWithParam<Case> {
 protected:
  std::mt19937 random{41};
  PatchChain chain = random_chain(GetParam().family, GetParam().continuity, random);
};
INSTANTIATE_TEST_SUITE_P(Families, Chain,
                         ::testing::Values(Case{"bezier-like", 1}, Case{"bezier-like", 2},
                                           Case{"h-bezier", 1}, Case{"h-bezier", 2}),
                         [](const auto& at) {
                           return at.param.family.substr(0, 1) +
                                  std::to_string(at.param.continuity);
                         });

TEST_P(Chain, HoldsAtEveryJoin) { EXPECT_TRUE(holds(chain, growth * tensor_relative)); }

TEST_P(Chain, HoldsForEveryValueOfEveryVariable) {
  const model::ChainLayout layout(chain);
  const Eigen::VectorXd numbers = model::to_numbers(chain, layout);
  for (const ChainVariable& variable : model::chain_variables(chain)) {
    if (variable.kind == ChainKind::point && variable.name.back() != 'z') continue;
    const double value = numbers[variable.members[0]];
    const double moved = variable.kind == ChainKind::point
                             ? value + 20.0
                             : 0.3 * value + 0.7 * (value > 0.5 * (variable.lower + variable.upper)
                                                        ? variable.lower
                                                        : variable.upper);
    Eigen::VectorXd other = numbers;
    for (const int member : variable.members) {
      EXPECT_EQ(numbers[member], value) << variable.name;
      other[member] = moved;
    }
    PatchChain changed = chain;
    model::set_numbers(changed, layout, other);
    model::propagate(changed);
    EXPECT_TRUE(holds(changed, growth * tensor_relative)) << variable.name;
  }
}

// With all points fixed a join holds exactly where a variable says so.
TEST_P(Chain, ReportsWhichShapesKeepTheJoinsWithAllPointsFixed) {
  const model::ChainLayout layout(chain);
  const Eigen::VectorXd numbers = model::to_numbers(chain, layout);
  int stay = 0, move = 0;
  for (const ChainVariable& variable : model::chain_variables(chain)) {
    if (variable.kind != ChainKind::shape) continue;
    Eigen::VectorXd other = numbers;
    const double value = numbers[variable.members[0]];
    for (const int member : variable.members)
      other[member] = value > 0.4 ? value - 0.3 : value + 0.3;
    PatchChain changed = chain;
    model::set_numbers(changed, layout, other);
    EXPECT_EQ(holds(changed, 1e-8), variable.points_stay) << variable.name;
    (variable.points_stay ? stay : move) += 1;
  }
  EXPECT_GT(stay, 0);
  // With G1 every alpha of an H-Bezier patch only changes a ratio.
  EXPECT_EQ(move > 0, GetParam().family == "bezier-like" || GetParam().continuity == 2);
}

TEST_P(Chain, PullbackIsTheDerivative) {
  const model::ChainLayout layout(chain);
  const Eigen::VectorXd numbers = model::to_numbers(chain, layout);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<model::FamilyPatchBar> weights;
  for (const model::FamilyPatch& patch : chain.patches) {
    model::FamilyPatchBar& bar = weights.emplace_back(patch);
    for (Vector3d& b : bar.points) b = {unit(random), unit(random), unit(random)};
  }
  const auto value = [&](const Eigen::VectorXd& x) {
    PatchChain at = chain;
    model::set_numbers(at, layout, x);
    model::propagate(at);
    double sum = 0.0;
    for (std::size_t p = 0; p < at.patches.size(); ++p) {
      for (std::size_t k = 0; k < at.patches[p].points.size(); ++k)
        sum += at.patches[p].points[k].dot(weights[p].points[k]);
    }
    return sum;
  };
  std::vector<model::FamilyPatchBar> bars = weights;
  const Eigen::VectorXd numbers_bar = model::propagate_pullback(chain, layout, bars);
  for (const ChainVariable& variable : model::chain_variables(chain)) {
    double actual = 0.0;
    for (const int member : variable.members) actual += numbers_bar[member];
    const double step = variable.kind == ChainKind::point ? 1.0 : 1e-5;
    Eigen::VectorXd above = numbers, below = numbers;
    for (const int member : variable.members) {
      above[member] += step;
      below[member] -= step;
    }
    double slope = 0.0;
    try {
      slope = (value(above) - value(below)) / (2.0 * step);
    } catch (const std::invalid_argument&) {
      continue;  // at the end of a range
    }
    EXPECT_NEAR(actual, slope, 1e-5 * (1.0 + std::abs(slope))) << variable.name;
  }
}

TEST_P(Chain, GivesDeterminedPointsNoAdjoint) {
  const model::ChainLayout layout(chain);
  std::vector<model::FamilyPatchBar> bars;
  for (const model::FamilyPatch& patch : chain.patches) {
    model::FamilyPatchBar& bar = bars.emplace_back(patch);
    for (Vector3d& b : bar.points) b.setOnes();
  }
  const Eigen::VectorXd numbers_bar = model::propagate_pullback(chain, layout, bars);
  EXPECT_EQ(numbers_bar.segment<3>(layout.point(1, 0)), Vector3d::Zero());
  EXPECT_NE(numbers_bar.segment<3>(layout.point(1, 3)), Vector3d::Zero());
}

TEST(ChainVariables, NamesTiedShapesOnce) {
  std::mt19937 random(42);
  const PatchChain chain = random_chain("bezier-like", 2, random);
  std::vector<std::string> names;
  for (const ChainVariable& variable : model::chain_variables(chain)) {
    if (variable.kind != ChainKind::point) names.push_back(variable.name);
  }
  // lambda of one and two is gamma 0..2 of three; gammas 4..6 of three are 0..2 of four.
  const std::vector<std::string> expected{
      "shape.one.u[0]",  "shape.one.v[0]",   "shape.one.v[1]",   "shape.one.v[2]",
      "shape.one.v[3]",  "shape.two.v[0]",   "shape.two.v[1]",   "shape.two.v[2]",
      "shape.two.v[3]",  "shape.three.u[0]", "shape.three.v[3]", "shape.three.v[4]",
      "shape.four.u[0]", "shape.four.v[3]",  "shape.four.v[4]",  "shape.four.v[5]",
      "shape.four.v[6]", "ratio.two",        "slide.two",        "ratio.three",
      "slide.three",     "ratio.four",       "slide.four"};
  EXPECT_EQ(names, expected);
}

TEST(PatchChain, RefusesCountsThatDoNotFit) {
  std::mt19937 random(43);
  PatchChain chain = random_chain("h-bezier", 1, random);
  chain.joins.pop_back();
  EXPECT_THROW(model::propagate(chain), std::invalid_argument);
  chain.patches.clear();
  EXPECT_THROW(model::propagate(chain), std::invalid_argument);
}

TEST(CurveChain, ClosedOutlineHasTangentsEverywhere) {
  std::mt19937 random(44);
  model::CurveChain chain;
  chain.name = "outline";
  for (int k = 0; k < 8; ++k) {
    model::FamilyCurve curve = random_curve("h-bezier", 3, random);
    curve.name = "curve" + std::to_string(k);
    const double angle = 0.785 * k;
    for (int i = 0; i < 4; ++i) {
      const double at = angle + 0.785 * i / 3.0;
      curve.points[i] = 500.0 * Vector3d(std::cos(at), std::sin(at), 0.1 * std::sin(3.0 * at));
    }
    chain.curves.push_back(std::move(curve));
    chain.joins.push_back({1, 0.8 + 0.05 * k, 0.0});
  }
  ASSERT_TRUE(chain.closed());
  model::propagate(chain);
  for (int k = 0; k < 8; ++k) {
    const JoinMeasure measure = model::measure_join(chain.curves[k], chain.curves[(k + 1) % 8]);
    EXPECT_LE(measure.gap_mm, 1e-12);
    EXPECT_LE(measure.direction_deg, normal_deg);
  }
}

TEST(CurveChain, ClosingJoinNeedsFreePoints) {
  std::mt19937 random(45);
  model::CurveChain chain;
  chain.curves = {random_curve("h-bezier", 3, random), random_curve("h-bezier", 3, random)};
  chain.joins = {{2, 1.0, 0.0}, {1, 1.0, 0.0}};
  EXPECT_THROW(model::propagate(chain), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::testing
