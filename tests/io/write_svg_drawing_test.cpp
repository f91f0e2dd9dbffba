#include "io/write_svg_drawing.hpp"

#include <random>

#include "tests/io/drawing_support.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;

class WrittenSvg : public testing::DrawingFiles {
 protected:
  model::Drawing round_trip(const model::Drawing& drawing,
                            const io::SvgDrawingOptions& options = {}) const {
    return read("a.svg", io::svg_drawing(drawing, options));
  }
};

model::Drawing some_drawing() {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> coordinate(-1000.0, 5000.0);
  const auto point = [&] { return Vector2d(coordinate(engine), coordinate(engine)); };
  model::Drawing drawing;
  drawing.unit_mm = 0.5;
  for (const char* layer : {"", "side", "side/left & right", "top"}) {
    model::DrawnPath path{"roof <1>", layer, {}, false};
    Vector2d at = point();
    for (int k = 0; k < 3; ++k) {
      path.segments.push_back({{at, point(), point(), point()}});
      at = path.segments.back().points[3];
    }
    path.segments.push_back(model::line_segment(at, point()));
    drawing.paths.push_back(path);
  }
  drawing.paths[1].segments.push_back(model::line_segment(
      drawing.paths[1].segments.back().points[3], drawing.paths[1].segments.front().points[0]));
  drawing.paths[1].closed = true;
  return drawing;
}

TEST_F(WrittenSvg, ComesBackBitForBit) {
  const model::Drawing drawing = some_drawing(), back = round_trip(drawing);
  EXPECT_DOUBLE_EQ(back.unit_mm, drawing.unit_mm);
  ASSERT_EQ(back.paths.size(), drawing.paths.size());
  for (std::size_t k = 0; k < back.paths.size(); ++k) {
    EXPECT_EQ(back.paths[k].name, drawing.paths[k].name);
    EXPECT_EQ(back.paths[k].layer, drawing.paths[k].layer);
    EXPECT_EQ(back.paths[k].closed, drawing.paths[k].closed);
    ASSERT_EQ(back.paths[k].segments.size(), drawing.paths[k].segments.size());
    for (std::size_t i = 0; i < back.paths[k].segments.size(); ++i)
      EXPECT_EQ(back.paths[k].segments[i].points, drawing.paths[k].segments[i].points);
  }
}

TEST_F(WrittenSvg, GivesEachPathAnIdentifierOfItsOwn) {
  const std::string text = io::svg_drawing(some_drawing());
  EXPECT_THAT(text, ::testing::HasSubstr("id=\"roof__1_\""));
  EXPECT_THAT(text, ::testing::HasSubstr("id=\"roof__1_-2\""));
}

TEST_F(WrittenSvg, LocksLayersAndAddsWordsThatAreNotRead) {
  io::SvgDrawingOptions options;
  options.locked = {"side"};
  options.texts = {{"a word", "side", {1.0, 2.0}, 10.0}};
  options.style = [](const model::DrawnPath& path) {
    return io::SvgStyle{path.layer == "top" ? "#ff0000" : "#000000", 2.5};
  };
  const std::string text = io::svg_drawing(some_drawing(), options);
  EXPECT_THAT(text, ::testing::HasSubstr("insensitive=\"true\""));
  EXPECT_THAT(text, ::testing::HasSubstr(">a word</text>"));
  EXPECT_THAT(text, ::testing::HasSubstr("stroke:#ff0000;stroke-width:2.5"));
  EXPECT_EQ(round_trip(some_drawing(), options).paths.size(), 4U);
}

TEST_F(WrittenSvg, IsNotReplacedUnlessAllowed) {
  const auto path = file("old.svg", "old");
  EXPECT_THROW(io::write_svg_drawing(some_drawing(), path), io::InputError);
  io::write_svg_drawing(some_drawing(), path, {}, io::Overwrite::allowed);
  EXPECT_EQ(io::read_drawing(path).paths.size(), 4U);
}

}  // namespace
}  // namespace bodyline
