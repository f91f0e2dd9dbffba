#include "sketch/curve_degrees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "io/read_model.hpp"
#include "model/connect.hpp"
#include "sketch/curve_jet.hpp"
#include "sketch/gather_strokes.hpp"
#include "sketch/sketch_model.hpp"
#include "tests/sketch/drawn_curves.hpp"

namespace bodyline {
namespace {

using Eigen::Vector3d;
using sketch::CurveDegrees;
using sketch::with_degrees;

// Numbers up to some thousand after some hundred operations.
constexpr double rounding = 1e-8;

model::Model car(const std::string& name) {
  return io::read_model(std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars" / (name + ".toml"));
}

int degree_of(const model::Model& model, const std::string& name) {
  const auto found = std::find_if(model.curves.begin(), model.curves.end(),
                                  [&](const model::Curve& curve) { return curve.name == name; });
  return int(found->points.size()) - 1;
}

double largest_difference(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double largest = 0.0;
  for (int k = 0; k <= 50; ++k)
    largest = std::max(
        largest,
        (sketch::curve_jet<3>(a, k / 50.0).point - sketch::curve_jet<3>(b, k / 50.0).point).norm());
  return largest;
}

TEST(CurveDegrees, RaisedTheCurvesStayWhereTheyAre) {
  const model::Model before = car("model1"), after = with_degrees(before, {7, {}});
  for (std::size_t c = 0; c < before.curves.size(); ++c) {
    EXPECT_EQ(after.curves[c].points.size(), 8U);
    EXPECT_LT(largest_difference(before.curves[c].points, after.curves[c].points), rounding);
  }
}

TEST(CurveDegrees, LoweredAgainTheyAreWhatTheyWere) {
  const std::vector<Vector3d> curve{{0, 0, 0}, {100, -300, 50}, {700, -200, 90}, {1000, 0, 0}};
  const auto back = sketch::in_degree(sketch::in_degree(curve, 6), 3);
  ASSERT_EQ(back.size(), curve.size());
  for (std::size_t k = 0; k < curve.size(); ++k) EXPECT_LT((back[k] - curve[k]).norm(), rounding);
}

TEST(CurveDegrees, LoweredTheyKeepTheirEnds) {
  const model::Model before = car("model1"), after = with_degrees(before, {2, {}});
  for (std::size_t c = 0; c < before.curves.size(); ++c) {
    EXPECT_EQ(after.curves[c].points.front(), before.curves[c].points.front());
    EXPECT_EQ(after.curves[c].points.back(), before.curves[c].points.back());
  }
}

TEST(CurveDegrees, LeaveABodyThatIsConnectedAndSymmetric) {
  for (const int degree : {3, 4, 6, 9}) {
    const model::Model after = with_degrees(car("model1"), {degree, {}});
    EXPECT_NO_THROW(model::connect(after)) << degree;  // it checks shapes, ends and mirror images
    for (const model::Curve& curve : after.curves) EXPECT_EQ(int(curve.points.size()), degree + 1);
  }
}

TEST(CurveDegrees, OfACurveAreThoseOfTheCurvesOppositeToIt) {
  const model::Model before = car("model1");
  const model::Model after = with_degrees(before, {std::nullopt, {{"roof__side_window", 6}}});
  EXPECT_NO_THROW(model::connect(after));
  for (const char* name : {"roof__side_window", "side_window__door_upper", "door_bottom"})
    EXPECT_EQ(degree_of(after, name), 6) << name;
  EXPECT_EQ(degree_of(after, "grille_bottom"), degree_of(before, "grille_bottom"));
}

TEST(CurveDegrees, OfASingleCurveCountBeforeThatOfAll) {
  const model::Model after = with_degrees(car("model1"), {4, {{"roof__side_window", 6}}});
  EXPECT_EQ(degree_of(after, "door_bottom"), 6);
  EXPECT_EQ(degree_of(after, "grille_bottom"), 4);
}

std::string refusal(const CurveDegrees& degrees) {
  try {
    with_degrees(car("model1"), degrees);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CurveDegrees, AreRefusedWithASentence) {
  EXPECT_EQ(refusal({10, {}}), "the degree of a curve is a whole number from 2 to 9, not 10");
  EXPECT_EQ(refusal({std::nullopt, {{"door_botom", 4}}}),
            "no curve is named 'door_botom'; the nearest name is 'door_bottom'");
  EXPECT_EQ(refusal({std::nullopt, {{"door_bottom", 4}, {"roof__side_window", 5}}}),
            "the curves 'door_bottom' and 'roof__side_window' lie on opposite sides of patches, so "
            "they need one degree, not 4 and 5");
}

TEST(CurveDegrees, AreThoseOfTheSketchedBody) {
  const model::Model truth = car("model1");
  const model::Model start = with_degrees(car("template"), {6, {}});
  testing::DrawOptions options;
  options.points = 200;
  const auto result = sketch::sketch_model(start, testing::drawn_curves(truth, options));
  for (std::size_t c = 0; c < truth.curves.size(); ++c) {
    EXPECT_EQ(result.model.curves[c].points.size(), 7U);
    // Where the curve runs, whatever its parameters: 0.5 mm of noise meets as much as it did.
    for (const auto& view : result.curves[c].views) EXPECT_LT(view.rms, 1.0);
  }
}

}  // namespace
}  // namespace bodyline
