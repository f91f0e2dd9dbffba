#include "io/place_drawings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace bodyline {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using io::Nose;
using io::ViewDrawing;
using model::View;

// A few roundings of numbers up to 10000.
constexpr double rounding = 1e-10;

// A car of 4500 x 1800 x 1400 mm, drawn as its outline in a view.
const Vector3d car_size(4500.0, 1800.0, 1400.0);

// A rectangle with a nick that tells where the nose and the ground are: from `nick` inwards.
model::DrawnPath outline(const Vector2d& corner, const Vector2d& size) {
  model::DrawnPath path;
  path.closed = true;
  const std::vector<Vector2d> points{{0, 0.1}, {0.2, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.1}};
  for (std::size_t k = 1; k < points.size(); ++k)
    path.segments.push_back(model::line_segment(corner + size.cwiseProduct(points[k - 1]),
                                                corner + size.cwiseProduct(points[k])));
  return path;
}

// The car in a view, `scale` mm per unit, somewhere on its page.
ViewDrawing drawn(View view, double scale, double longer = 1.0) {
  const Eigen::AlignedBox3d car(Vector3d(0, -900, 0), Vector3d(4500, 900, 1400));
  const Vector2d a = project(view, car.min()), b = project(view, car.max());
  ViewDrawing result;
  result.view = view;
  Vector2d size = (b - a).cwiseAbs() / scale;
  size.x() *= longer;
  result.drawing.paths = {outline({321.0, -77.0}, size)};
  return result;
}

io::PlaceOptions options_for_car() {
  io::PlaceOptions options;
  options.body = Eigen::AlignedBox3d(Vector3d(-20, -850, 5), Vector3d(4000, 850, 1300));
  return options;
}

std::string refusal(const std::vector<ViewDrawing>& views, const io::PlaceOptions& options) {
  try {
    io::place_drawings(views, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PlacedDrawings, ShareTheirSizes) {
  std::vector<ViewDrawing> views{drawn(View::side, 2.0), drawn(View::top, 3.0),
                                 drawn(View::front, 4.0), drawn(View::rear, 5.0)};
  const std::array<std::optional<double> io::PlaceOptions::*, 3> known{
      &io::PlaceOptions::length, &io::PlaceOptions::width, &io::PlaceOptions::height};
  for (int k = 0; k < 3; ++k) {
    io::PlaceOptions options = options_for_car();
    options.*known[k] = car_size[k];
    const auto placed = io::place_drawings(views, options);
    EXPECT_THAT(placed.scales, ::testing::Pointwise(::testing::DoubleNear(rounding),
                                                    std::vector<double>{2, 3, 4, 5}));
    EXPECT_LT((placed.size - car_size).norm(), rounding);
    EXPECT_TRUE(placed.notes.empty());
  }
  views[2].scale = 4.0;
  const auto placed = io::place_drawings(views, options_for_car());
  EXPECT_NEAR(placed.scales[1], 3.0, rounding);
}

TEST(PlacedDrawings, BeginAtTheNoseAndOnTheGroundOfTheModel) {
  io::PlaceOptions options = options_for_car();
  options.length = 4500.0;
  const auto placed = io::place_drawings(
      {drawn(View::side, 2.0), drawn(View::top, 3.0), drawn(View::front, 4.0)}, options);
  const auto box = [&](int k) { return model::drawn_box(placed.drawings[k].paths); };
  EXPECT_LT((box(0).min() - Vector2d(-20, 5)).norm(), rounding);
  EXPECT_LT((box(0).max() - Vector2d(4480, 1405)).norm(), rounding);
  EXPECT_LT((box(1).min() - Vector2d(-20, -900)).norm(), rounding);
  EXPECT_LT((box(2).min() - Vector2d(-900, 5)).norm(), rounding);
}

TEST(PlacedDrawings, LieAtTheirOrigin) {
  ViewDrawing view = drawn(View::side, 2.0);
  view.scale = 2.0;
  view.origin = Vector2d(321.0, -77.0);
  const auto placed = io::place_drawings({view}, options_for_car());
  EXPECT_LT(model::drawn_box(placed.drawings[0].paths).min().norm(), rounding);
}

TEST(PlacedDrawings, HaveTheNoseToTheLeft) {
  const Vector2d nick = Vector2d(0.2, 0.0), whole(4500, 1400);
  ViewDrawing view = drawn(View::side, 2.0);
  view.scale = 2.0;
  view.nose = Nose::right;
  view.origin = Vector2d(321.0, -77.0);
  const auto side = io::place_drawings({view}, options_for_car());
  // What was to the right of the origin is to its left now, at the same height.
  const Vector2d mirrored = side.drawings[0].paths[0].segments[0].points[3];
  EXPECT_LT((mirrored - Vector2d(-nick.x() * whole.x(), 0.0)).norm(), rounding);
}

TEST(PlacedDrawings, AreTurnedUntilTheNoseIsLeft) {
  // An arrow that points along the nose of a page, with a mark to the left of a driver.
  const std::vector<std::pair<Nose, std::array<Vector2d, 3>>> pages{
      {Nose::left, {Vector2d(1000, 0), Vector2d(-3000, 0), Vector2d(0, -1000)}},
      {Nose::right, {Vector2d(-1000, 0), Vector2d(3000, 0), Vector2d(0, 1000)}},
      {Nose::up, {Vector2d(0, -1000), Vector2d(0, 3000), Vector2d(-1000, 0)}},
      {Nose::down, {Vector2d(0, 1000), Vector2d(0, -3000), Vector2d(1000, 0)}}};
  for (const auto& [nose, points] : pages) {
    ViewDrawing view;
    view.view = View::top;
    view.nose = nose;
    view.scale = 1.0;
    view.origin = Vector2d(0, 0);
    view.drawing.paths.resize(1);
    view.drawing.paths[0].segments = {model::line_segment(points[0], points[1]),
                                      model::line_segment(points[1], points[2])};
    const auto placed = io::place_drawings({view}, options_for_car());
    const auto& segments = placed.drawings[0].paths[0].segments;
    // The nose at smaller x, the driver's left at y < 0.
    EXPECT_LT((segments[0].points[0] - Vector2d(1000, 0)).norm(), rounding) << nose_name(nose);
    EXPECT_LT((segments[1].points[3] - Vector2d(0, -1000)).norm(), rounding) << nose_name(nose);
  }
}

TEST(PlacedDrawings, MeetInTheMiddleWhereTheyDifferLittle) {
  io::PlaceOptions options = options_for_car();
  options.height = 1400.0;
  const auto placed = io::place_drawings(
      {drawn(View::side, 2.0), drawn(View::front, 4.0), drawn(View::top, 3.0, 1.03)}, options);
  // By least squares of the logarithms the excess of 3 % is shared out among the three sides of the
  // ring length, width, height that the views make.
  EXPECT_GT(placed.size.x(), 4500.0);
  EXPECT_LT(placed.size.x(), 1.03 * 4500.0);
  EXPECT_EQ(placed.size.z(), 1400.0);
  ASSERT_FALSE(placed.notes.empty());
  EXPECT_THAT(placed.notes[0], ::testing::HasSubstr("The drawings differ in their "));
}

TEST(PlacedDrawings, AreRefusedWhereTheyDifferMuch) {
  io::PlaceOptions options = options_for_car();
  options.length = 4500.0;
  options.height = 1600.0;
  EXPECT_THAT(refusal({drawn(View::side, 2.0)}, options),
              ::testing::StartsWith("the drawings differ in their length by"));
}

TEST(PlacedDrawings, KeepGivenScalesAndSayHowTheyDiffer) {
  std::vector<ViewDrawing> views{drawn(View::side, 2.0), drawn(View::top, 3.0)};
  views[0].scale = 2.0;
  views[1].scale = 3.3;
  const auto placed = io::place_drawings(views, options_for_car());
  EXPECT_EQ(placed.scales[1], 3.3);
  EXPECT_THAT(placed.notes, ::testing::ElementsAre("The drawings differ in their length by 10.0 %: "
                                                   "4500 mm in side, 4950 mm in top."));
}

TEST(PlacedDrawings, OfFullSizeNeedNoScale) {
  ViewDrawing side = drawn(View::side, 10.0);
  side.drawing.unit_mm = 10.0;
  const auto placed = io::place_drawings({side, drawn(View::front, 3.0)}, options_for_car());
  EXPECT_NEAR(placed.scales[1], 3.0, rounding);
  EXPECT_THAT(placed.notes,
              ::testing::ElementsAre("The view side is taken to be drawn at full size."));
  side.drawing.unit_mm = 1.0;
  EXPECT_EQ(refusal({side}, options_for_car()),
            "nothing says how large the car is in the view side: give a scale, or its length or "
            "height");
}

TEST(PlacedDrawings, NeedASizeThatTheyShow) {
  io::PlaceOptions options = options_for_car();
  options.width = 1800.0;
  EXPECT_THAT(refusal({drawn(View::side, 2.0)}, options),
              ::testing::StartsWith("nothing says how large the car is in the view side"));
}

TEST(PlacedDrawings, RefuseWhatIsNoNumberOrNoDrawing) {
  io::PlaceOptions options = options_for_car();
  options.length = -1.0;
  EXPECT_EQ(refusal({drawn(View::side, 2.0)}, options), "the length is a number above 0, in mm");
  options.length = 4500.0;
  ViewDrawing flat = drawn(View::side, 2.0);
  flat.drawing.paths = {outline({0, 0}, {100.0, 0.0})};
  EXPECT_EQ(refusal({flat}, options),
            "the drawing of the view side is flat: it has no width or no height");
  flat.drawing.paths.clear();
  EXPECT_EQ(refusal({flat}, options), "nothing is drawn in the view side");
  ViewDrawing front = drawn(View::front, 2.0);
  front.nose = Nose::right;
  EXPECT_EQ(refusal({front}, options), "the nose does not point right in a view front");
}

}  // namespace
}  // namespace bodyline
