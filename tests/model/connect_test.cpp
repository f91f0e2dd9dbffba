#include "model/connect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "check_models.hpp"

/// What `connect` refuses and derives.
namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::Side;

constexpr double rounding = 1e-9;  // mm and degrees

model::ModelError refusal(const model::Model& model) {
  try {
    model::connect(model);
  } catch (const model::ModelError& error) {
    return error;
  }
  throw std::logic_error("the model was accepted");
}

// One degree more, the same curve.
void elevate(model::Curve& curve) {
  const std::vector<Vector3d> points = curve.points;
  const double n = double(points.size());
  for (std::size_t j = 1; j < points.size(); ++j)
    curve.points[j] = (double(j) * points[j - 1] + (n - double(j)) * points[j]) / n;
  curve.points.push_back(points.back());
}

// The joint's curve with a degree more than the opposite sides have; a central patch, whose v0 and
// v1 are this curve, keeps in step.
model::Model with_mismatch(model::Model box, const std::string& joint) {
  for (int c = 0; c < int(box.curves.size()); ++c) {
    if (box.curves[c].name != joint) continue;
    elevate(box.curves[c]);
    for (model::Patch& patch : box.patches) {
      if (patch.central && patch.sides[2].curve == c) patch.shape_u.push_back(1.0);
    }
  }
  return box;
}

// A joint is one curve, so that its two sides cannot differ; what can differ is the joint's curve
// and the opposite side of a patch.
TEST(Connect, ADegreeMismatchAlongAnyJointNamesTheSideAndBothCounts) {
  const model::Model box = plain_box();
  for (const model::Joint& joint : box.joints) {
    const model::ModelError error = refusal(with_mismatch(box, joint.name));
    EXPECT_THAT(error.key(), ::testing::MatchesRegex("patches\\.[a-z]+\\.[uv][01]")) << joint.name;
    EXPECT_THAT(std::string(error.what()),
                ::testing::AnyOf(::testing::ContainsRegex("has 4 points where .* has 3"),
                                 ::testing::ContainsRegex("has 3 points where .* has 4")))
        << joint.name;
  }
}

// The top of the plain box and its left side, joined along one curve; only the side is cut.
model::Model uncut_top() {
  const model::Model box = plain_box();
  model::Model half;
  half.name = "half";
  const std::array<int, 6> curves{1, 2, 4, 5, 6, 7};
  for (const int curve : curves) half.curves.push_back(box.curves[curve]);
  half.patches = {box.patches[1], box.patches[4]};
  for (model::Patch& patch : half.patches) {
    for (model::SideCurve& use : patch.sides)
      use.curve = int(std::find(curves.begin(), curves.end(), use.curve) - curves.begin());
    patch.cut_u = patch.cut_v = {0.0, 1.0};
  }
  half.patches[1].cut_v[1] = 0.9;
  model::Joint joint;
  joint.name = half.curves[3].name;
  joint.a = {0, Side::v0};
  joint.b = {1, Side::v1};
  joint.uncut = 0;
  half.joints = {joint};
  return half;
}

TEST(Connect, ACentralPatchMayBeTheUncutSideOfItsJoint) {
  const model::Model half = uncut_top();
  const model::Connectivity links = model::connect(half);
  for (const Side side : model::all_sides) {
    EXPECT_FALSE(model::side_is_cut(half, links, 0, side)) << model::side_name(side);
    EXPECT_EQ(model::side_is_cut(half, links, 1, side), side == Side::v1) << model::side_name(side);
  }
  for (const model::EdgeCheck& edge : model::check_body(half).edges) {
    EXPECT_LE(edge.deviation.gap_mm, rounding);
    EXPECT_LE(edge.deviation.normal_deviation_deg, rounding);
  }
}

TEST(Connect, AJointNamesTheSideThatIsNotOnItsCurve) {
  model::Model box = plain_box();
  box.joints[0].a.side = box.joints[0].a.side == Side::u0 ? Side::u1 : Side::u0;
  const model::ModelError error = refusal(box);
  EXPECT_EQ(error.key(), "joints." + box.joints[0].name + ".between");
}

TEST(Connect, ASideWithoutCurveIsNamed) {
  model::Model box = plain_box();
  box.patches[2].sides[static_cast<int>(Side::v0)].curve = -1;
  EXPECT_EQ(refusal(box).key(), "patches.rear.v0");
}

// Points that differ by more than what closes a corner must not look alike in the sentence.
TEST(Connect, PointsThatDifferAreShownWithDifferentNumbers) {
  for (const double gap : {1.0, 1e-3, 1e-6, 2e-9}) {
    model::Model box = plain_box();
    box.curves[4].points.front().z() += gap;
    const std::string sentence = refusal(box).what();
    const std::size_t first = sentence.find('('), second = sentence.find('(', first + 1);
    ASSERT_NE(second, std::string::npos) << sentence;
    const auto point = [&](std::size_t at) {
      return sentence.substr(at, sentence.find(')', at) - at);
    };
    EXPECT_NE(point(first), point(second)) << sentence;
  }
}

}  // namespace
}  // namespace bodyline::testing
