#include <cmath>

#include "io/svg_arc.hpp"
#include "io/svg_length.hpp"
#include "tests/io/drawing_support.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;
using testing::svg;

// A few roundings of numbers up to 1000.
constexpr double rounding = 1e-12;

class SvgDrawing : public testing::DrawingFiles {
 protected:
  model::Drawing read_svg(const std::string& inner, const std::string& attributes = "") const {
    return read("a.svg", svg(inner, attributes));
  }
  std::vector<std::string> names(const model::Drawing& drawing) const {
    std::vector<std::string> found;
    for (const model::DrawnPath& path : drawing.paths)
      found.push_back(path.layer + ":" + path.name);
    return found;
  }
  // Where a path begins.
  Vector2d start(const model::Drawing& drawing, std::size_t path = 0) const {
    return drawing.paths.at(path).segments.front().points.front();
  }
};

TEST_F(SvgDrawing, TurnsYUp) {
  const auto drawing = read_svg("<path d='M 1 2 L 3 4'/>");
  EXPECT_EQ(start(drawing), Vector2d(1, -2));
  EXPECT_TRUE(drawing.y_down);
}

TEST_F(SvgDrawing, NamesPathsByLabelOrId) {
  EXPECT_THAT(names(read_svg("<path id='p1' inkscape:label='roof' d='M 0 0 H 1'/>"
                             "<path id='sill' d='M 0 0 H 1'/><path d='M 0 0 H 1'/>")),
              ::testing::ElementsAre(":roof", ":sill", ":"));
}

TEST_F(SvgDrawing, NamesLayersByTheirGroups) {
  EXPECT_THAT(names(read_svg("<g inkscape:label='side' id='layer1'><g><g id='glass'>"
                             "<path id='a' d='M 0 0 H 1'/></g></g><path id='b' d='M 0 0 H 1'/></g>"
                             "<path id='c' d='M 0 0 H 1'/>")),
              ::testing::ElementsAre("side/glass:a", "side:b", ":c"));
}

TEST_F(SvgDrawing, NestsTransforms) {
  const auto drawing = read_svg(
      "<g transform='translate(100 0)'><g transform='scale(2)'>"
      "<path transform='rotate(90)' d='M 1 0 H 3'/></g></g>");
  EXPECT_LT((start(drawing) - Vector2d(100, -2)).norm(), rounding);
}

TEST_F(SvgDrawing, DrawsEveryShape) {
  const auto drawing = read_svg(
      "<line x1='1' y1='2' x2='3' y2='4'/><polyline points='0,0 1,1 2,0'/>"
      "<polygon points='0 0 1 1 2 0'/><rect x='1' y='2' width='10' height='6'/>"
      "<rect width='10' height='6' rx='2'/><circle cx='5' cy='6' r='2'/>"
      "<ellipse cx='5' cy='6' rx='3' ry='1'/>");
  ASSERT_EQ(drawing.paths.size(), 7U);
  const auto box = [&](std::size_t k) { return model::drawn_box({&drawing.paths[k], 1}); };
  EXPECT_EQ(box(0).sizes(), Vector2d(2, 2));
  EXPECT_FALSE(drawing.paths[1].closed);
  EXPECT_TRUE(drawing.paths[2].closed);
  EXPECT_EQ(drawing.paths[2].segments.size(), 3U);
  EXPECT_EQ(box(3).min(), Vector2d(1, -8));
  EXPECT_EQ(box(3).sizes(), Vector2d(10, 6));
  EXPECT_EQ(drawing.paths[3].segments.size(), 4U);
  EXPECT_LT((box(4).sizes() - Vector2d(10, 6)).norm(), rounding);
  // Four edges and four corners of 90 degrees in pieces of 30.
  EXPECT_EQ(drawing.paths[4].segments.size(), 16U);
  EXPECT_LT((box(5).sizes() - Vector2d(4, 4)).norm(), 4.0 * io::arc_tolerance);
  EXPECT_LT((box(5).center() - Vector2d(5, -6)).norm(), 4.0 * io::arc_tolerance);
  EXPECT_LT((box(6).sizes() - Vector2d(6, 2)).norm(), 6.0 * io::arc_tolerance);
}

// Every segment begins where the one before ends, and a closed path ends where it began.
TEST_F(SvgDrawing, LeavesNoGapsInAPath) {
  const auto drawing = read_svg(
      "<rect x='0.1' y='0.3' width='10.7' height='6.1' rx='2.3' ry='1.1'/>"
      "<circle cx='0.1' cy='0.7' r='3.3'/>"
      "<path d='M 0.1 0.2 h 0.3 a 3 2 20 1 0 0.1 0.1 q 1 2 3 4 z'/>");
  for (const model::DrawnPath& path : drawing.paths) {
    for (std::size_t k = 1; k < path.segments.size(); ++k)
      EXPECT_LT((path.segments[k].points[0] - path.segments[k - 1].points[3]).norm(), rounding);
    EXPECT_LT((path.segments.front().points[0] - path.segments.back().points[3]).norm(), rounding);
  }
}

TEST_F(SvgDrawing, SkipsWhatIsHidden) {
  EXPECT_THAT(names(read_svg("<style>.cls-1, #off { fill: none; display: none }</style>"
                             "<g style='display:none'><path id='a' d='M 0 0 H 1'/></g>"
                             "<g display='none'><path id='b' d='M 0 0 H 1'/></g>"
                             "<path id='c' class='x cls-1' d='M 0 0 H 1'/>"
                             "<path id='off' d='M 0 0 H 1'/>"
                             "<g visibility='hidden'><path id='d' d='M 0 0 H 1'/>"
                             "<path id='e' style='visibility: visible' d='M 0 0 H 1'/></g>"
                             "<path id='f' style='fill:none;display:inline' d='M 0 0 H 1'/>")),
              ::testing::ElementsAre(":e", ":f"));
}

TEST_F(SvgDrawing, PassesOverWhatDrawsNoLines) {
  EXPECT_THAT(names(read_svg("<defs><path id='a' d='M 0 0 H 1'/></defs>"
                             "<clipPath><path id='b' d='M 0 0 H 1'/></clipPath>"
                             "<text x='1'>words</text><image href='photo.png'/>"
                             "<path id='c' d='M 0 0 H 1'/>")),
              ::testing::ElementsAre(":c"));
}

TEST_F(SvgDrawing, DrawsWhatIsUsed) {
  const auto drawing = read_svg(
      "<defs><path id='a' d='M 1 1 H 2'/><symbol id='s'><path id='b' d='M 5 0 H "
      "6'/></symbol></defs>"
      "<use href='#a' x='10' y='20'/><use xlink:href='#s' transform='scale(2)'/>");
  EXPECT_EQ(start(drawing, 0), Vector2d(11, -21));
  EXPECT_EQ(start(drawing, 1), Vector2d(10, 0));
  EXPECT_EQ(drawing.paths[0].name, "a");
}

TEST_F(SvgDrawing, PlacesInnerDrawings) {
  const auto drawing = read_svg(
      "<svg x='10' y='20' width='100' height='100' viewBox='5 5 10 20'>"
      "<path d='M 5 5 L 15 25'/></svg>");
  // Ten units across would be ten times, twenty upwards five times as large: five, in the middle.
  EXPECT_LT((start(drawing) - Vector2d(35, -20)).norm(), rounding);
  EXPECT_LT((drawing.paths[0].segments[0].points[3] - Vector2d(85, -120)).norm(), rounding);
}

TEST_F(SvgDrawing, KnowsItsUnitOnPaper) {
  const std::string line = "<path d='M 7 0 H 1'/>";
  EXPECT_NEAR(read_svg(line, "width='210mm' height='297mm' viewBox='0 0 210 297'").unit_mm, 1.0,
              rounding);
  EXPECT_NEAR(read_svg(line, "width='10cm' height='10cm' viewBox='0 0 1000 1000'").unit_mm, 0.1,
              rounding);
  EXPECT_NEAR(read_svg(line, "width='10in'").unit_mm, io::svg_pixel_mm, rounding);
  // The smaller scale counts: nothing is stretched.
  EXPECT_NEAR(read_svg(line, "width='10mm' height='30mm' viewBox='0 0 10 10'").unit_mm, 1.0,
              rounding);
  EXPECT_EQ(read_svg(line, "width='800' height='600' viewBox='0 0 400 300'").unit_mm, 0.0);
  EXPECT_EQ(read_svg(line, "width='100%' height='100%' viewBox='0 0 400 300'").unit_mm, 0.0);
  EXPECT_EQ(read_svg(line).unit_mm, 0.0);
  // The unit does not change the coordinates.
  EXPECT_EQ(start(read_svg(line, "width='21mm' viewBox='0 0 210 297'")), Vector2d(7, 0));
}

TEST_F(SvgDrawing, StretchesWhereTheFileSaysSo) {
  const auto drawing = read_svg("<path d='M 0 1 H 1'/>",
                                "width='10mm' height='20mm' viewBox='0 0 10 10' "
                                "preserveAspectRatio='none'");
  EXPECT_NEAR(drawing.unit_mm, 1.0, rounding);
  EXPECT_LT((start(drawing) - Vector2d(0, -2)).norm(), rounding);
}

TEST_F(SvgDrawing, TakesPrefixesOfItsNamespace) {
  EXPECT_EQ(read("a.svg",
                 "<?xml version='1.0'?><!DOCTYPE svg><svg:svg xmlns:svg='x'><svg:g>"
                 "<svg:path d='M 0 0 H 1'/></svg:g><sodipodi:path d='M 0 0 H 1'/></svg:svg>")
                .paths.size(),
            1U);
}

}  // namespace
}  // namespace bodyline
