// What is said where views of a curve disagree.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "io/read_model.hpp"
#include "sketch/sketch_model.hpp"
#include "sketch/view_checks.hpp"
#include "tests/sketch/drawn_curves.hpp"

namespace bodyline {
namespace {

using model::View;
using testing::DrawOptions;
using ::testing::HasSubstr;

model::Model car(const std::string& name) {
  return io::read_model(std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars" / (name + ".toml"));
}

const std::string moved_curve = "roof__side_window";  // long, and seen from everywhere

// Model 1 in some views, with one curve moved in one of them.
std::vector<model::PlacedDrawing> with_a_move(const std::vector<View>& views, View view,
                                              const Eigen::Vector2d& move) {
  DrawOptions options;
  options.points = 200;
  options.views = views;
  auto drawings = testing::drawn_curves(car("model1"), options);
  for (auto& drawing : drawings) {
    if (drawing.view != view) continue;
    for (auto& path : drawing.paths) {
      if (path.name != moved_curve) continue;
      for (auto& segment : path.segments)
        for (auto& point : segment.points) point += move;
    }
  }
  return drawings;
}

// Names of curves with contradictions, and their sentences.
std::map<std::string, std::vector<std::string>> contradictions(
    const std::vector<model::PlacedDrawing>& drawings, const sketch::SketchOptions& options = {}) {
  std::map<std::string, std::vector<std::string>> found;
  for (const auto& curve : sketch::sketch_model(car("template"), drawings, options).curves)
    if (!curve.contradictions.empty()) found[curve.curve] = curve.contradictions;
  return found;
}

TEST(Contradictions, NameTheThirdViewThatDeniesWhatTwoTell) {
  // 40 mm higher in front: side and top agree about x, and the front alone has another z.
  const auto found =
      contradictions(with_a_move({View::side, View::top, View::front}, View::front, {0.0, 40.0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.at(moved_curve),
              ::testing::Contains(HasSubstr("mm and more away from the line in the view")));
}

TEST(Contradictions, OfFourViewsSingleOutTheOneThatIsWrong) {
  const auto found = contradictions(with_a_move(model::all_views(), View::front, {0.0, 40.0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.at(moved_curve),
              ::testing::Contains(HasSubstr("the view front is the one in doubt")));
}

TEST(Contradictions, AreMeasuredByTheToleranceOfEachCurve) {
  const auto drawings = with_a_move({View::side, View::top, View::front}, View::front, {0.0, 40.0});
  sketch::SketchOptions options;
  options.tolerances[moved_curve] = 100.0;
  EXPECT_TRUE(contradictions(drawings, options).empty());
  options.tolerance = 100.0;
  options.tolerances[moved_curve] = 10.0;
  EXPECT_EQ(contradictions(drawings, options).size(), 1U);
}

TEST(ViewChecks, HoldBetweenViewsOfOneCar) {
  const model::Model model = car("model1");
  std::size_t count = 0;
  for (const auto hand : {testing::Hand::even_parameters, testing::Hand::even_lengths}) {
    DrawOptions options;
    options.hand = hand;
    const auto gathered = sketch::gather_strokes(model, testing::drawn_curves(model, options));
    std::vector<std::vector<sketch::SketchLine>> lines(model.curves.size());
    for (const auto& stroke : gathered.strokes)
      lines[stroke.curve].push_back(sketch::sketch_line(stroke));
    for (std::size_t c = 0; c < lines.size(); ++c) {
      for (const auto& check : sketch::view_checks(lines[c], sketch::is_central(model.curves[c]))) {
        // 0.5 mm of noise; an error along the axis comes out three times as large at most.
        EXPECT_LT(check.distance, 4.0) << model.curves[c].name;
        ++count;
      }
    }
  }
  EXPECT_GE(count, 2 * model.curves.size());
}

}  // namespace
}  // namespace bodyline
