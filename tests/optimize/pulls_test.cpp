// How strongly points of a scan pull at a body: the kernels against one point at a time.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimize/robust_pull.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double rounding = 1e-13;  // of weights of size 1
constexpr int count = 61;           // not whole groups
constexpr int padded = 64;
const PullReach reach{2.0, 5.0};

/// Feet with random points around them; every parameter is 0, 1 or between them in turn.
struct Feet {
  explicit Feet(bool inward);
  model::FootPointArrays arrays();
  Match match(int k, bool inward) const;
  Vector3d vector(int column, int k) const {
    return {columns[column][k], columns[column + 1][k], columns[column + 2][k]};
  }

  // point, scan's normal, u v, foot, normal; then weights, weighted targets, distances
  std::array<std::array<double, padded>, 24> columns{};
};

Feet::Feet(bool inward) {
  std::mt19937 random(9);
  const auto number = [&] { return 2.0 * double(random()) / double(std::mt19937::max()) - 1.0; };
  for (int k = 0; k < padded; ++k) {
    Vector3d normal(number(), number(), number()), scanned(number(), number(), number());
    normal.normalize();
    scanned = ((inward ? -1.0 : 1.0) * normal + 0.9 * scanned).normalized();
    for (int c = 0; c < 3; ++c) {
      columns[8 + c][k] = 10.0 * number();
      columns[c][k] = columns[8 + c][k] + 3.0 * number();
      columns[3 + c][k] = scanned[c];
      columns[11 + c][k] = normal[c];
    }
    columns[6][k] = k % 3 == 0 ? 0.0 : k % 3 == 1 ? 1.0 : 0.5;
    columns[7][k] = k % 5 == 0 ? 0.0 : k % 5 == 1 ? 1.0 : 0.25;
    // Points exactly above their feet have no direction along the surface.
    if (k % 7 == 0)
      for (int c = 0; c < 3; ++c) columns[c][k] = columns[8 + c][k];
  }
}

model::FootPointArrays Feet::arrays() {
  model::FootPointArrays a;
  a.count = count;
  a.x = columns[0].data(), a.y = columns[1].data(), a.z = columns[2].data();
  a.u = columns[6].data(), a.v = columns[7].data();
  for (int c = 0; c < 3; ++c)
    a.foot[c] = columns[8 + c].data(), a.normal[c] = columns[11 + c].data();
  return a;
}

Match Feet::match(int k, bool inward) const {
  Match match;
  match.u = columns[6][k], match.v = columns[7][k];
  match.foot = vector(8, k);
  match.normal = (inward ? -1.0 : 1.0) * vector(11, k);
  match.distance = (vector(0, k) - match.foot).norm();
  return match;
}

struct Case {
  bool normals, inward;
  std::array<bool, 4> rims;
};

class Pulls : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Cases, Pulls,
                         testing::Values(Case{true, false, {}}, Case{true, true, {}},
                                         Case{false, false, {}},
                                         Case{true, false, {true, false, false, false}},
                                         Case{true, true, {false, true, false, true}},
                                         Case{false, false, {false, false, true, false}}));

TEST_P(Pulls, OfManyPointsAreThoseOfOneAtATime) {
  const auto [normals, inward, rims] = GetParam();
  for (const model::Isa isa : {model::Isa::baseline, model::Isa::avx2, model::Isa::avx512}) {
    if (!model::isa_available(isa)) continue;
    Feet feet(inward);
    model::PullRule rule;
    for (int c = 0; c < 3 && normals; ++c) rule.scan_normal[c] = feet.columns[3 + c].data();
    rule.inward = inward;
    std::copy(rims.begin(), rims.end(), rule.rims);
    rule.normal_reach = reach.normal, rule.rim_reach = reach.rim;
    rule.least_rim_cosine = 0.6;
    model::PullArrays out;
    out.count = count;
    for (int e = 0; e < 6; ++e) out.weight[e] = feet.columns[14 + e].data();
    for (int c = 0; c < 3; ++c) out.weighted_target[c] = feet.columns[20 + c].data();
    const model::PullSums sums =
        model::kernels(isa).pulls(feet.arrays(), rule, out, feet.columns[23].data());
    model::PullSums expected;
    int pulled = 0;
    for (int k = 0; k < count; ++k) {
      const Vector3d point = feet.vector(0, k), normal = feet.vector(3, k);
      const Match match = feet.match(k, inward);
      const MatchPull pull = robust_pull(match, point, normals ? &normal : nullptr, rims, reach,
                                         rule.least_rim_cosine);
      const Eigen::Matrix3d& w = pull.weight;
      const double entries[6] = {w(0, 0), w(0, 1), w(0, 2), w(1, 1), w(1, 2), w(2, 2)};
      for (int e = 0; e < 6; ++e) ASSERT_NEAR(out.weight[e][k], entries[e], rounding) << k;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(out.weighted_target[c][k], (w * point)[c], 100.0 * rounding) << k;
      ASSERT_NEAR(feet.columns[23][k], match.distance, 100.0 * rounding);
      expected.constant += point.dot(w * point);
      expected.weight += w.trace();
      pulled += w.trace() > 0.0;
    }
    EXPECT_NEAR(sums.weight, expected.weight, 100.0 * rounding);
    EXPECT_NEAR(sums.constant, expected.constant, 1e4 * rounding);
    EXPECT_GT(pulled, count / 4);
    for (int k = count; k < padded; ++k)
      for (int e = 0; e < 6; ++e) EXPECT_EQ(out.weight[e][k], 0.0) << "beyond the points";
  }
}

}  // namespace
}  // namespace bodyline::optimize
