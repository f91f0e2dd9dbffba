// The command `sketch`, on files as an editor of drawings leaves them.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "io/read_model.hpp"
#include "io/write_svg_drawing.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/sketch/drawn_curves.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;
using model::View;
using ::testing::AllOf;
using testing::DrawOptions;
using ::testing::HasSubstr;

// The requirement: every control point of the car that was drawn.
constexpr double round_trip_error = 3.0;  // mm

model::DrawnPath axes() {
  return {model::axes_name,
          "",
          {model::line_segment({model::axes_length, 0.0}, {0.0, 0.0}),
           model::line_segment({0.0, 0.0}, {0.0, model::axes_length})},
          false};
}

// A path as it lies on the page.
model::DrawnPath placed(model::DrawnPath path, const std::string& layer, double scale,
                        const Vector2d& place) {
  path.layer = layer;
  for (model::CubicSegment& segment : path.segments)
    for (Vector2d& point : segment.points) point = point / scale + place;
  return path;
}

DrawOptions careful_hand() {
  DrawOptions options;
  options.points = 200;
  return options;
}

class SketchCommand : public testing::CommandLine {
 protected:
  static model::Model car_model(const std::string& name) { return io::read_model(car(name)); }

  // Model 1 drawn by hand, its views as layers of one file, each with its axes.
  void write_views(const std::string& name,
                   const std::vector<model::PlacedDrawing>& drawings) const {
    model::Drawing page;
    Vector2d place(500.0, 200.0);
    for (const model::PlacedDrawing& drawing : drawings) {
      const std::string layer = model::view_name(drawing.view);
      page.paths.push_back(placed(axes(), layer, 1.0, place));
      for (const model::DrawnPath& path : drawing.paths)
        page.paths.push_back(placed(path, layer, 1.0, place));
      place += Vector2d(6000.0, -300.0);
    }
    io::write_svg_drawing(page, file(name));
  }

  static std::vector<model::PlacedDrawing> drawn(const DrawOptions& options = careful_hand()) {
    return testing::drawn_curves(car_model("model1"), options);
  }

  double farthest_point(const std::string& name) const {
    const model::Model found = io::read_model(file(name)), truth = car_model("model1");
    double farthest = 0.0;
    for (std::size_t c = 0; c < truth.curves.size(); ++c)
      farthest = std::max(farthest, testing::largest_move(found.curves[c], truth.curves[c]));
    return farthest;
  }

  // The joints of the body: tangent planes agree as far as numbers can tell.
  void expect_smooth(const std::string& name) const {
    const auto run = bodyline({"check", name, "--json"});
    const auto report = nlohmann::json::parse(run.out);
    int joints = 0;
    for (const auto& edge : report.at("edges")) {
      if (edge.at("stage") != "body") continue;
      EXPECT_LT(edge.at("normal_deviation_deg"), 1e-6) << edge.at("name");
      EXPECT_LT(edge.at("gap_mm"), 1e-6) << edge.at("name");
      ++joints;
    }
    EXPECT_GT(joints, 10);
  }
};

void remove_path(std::vector<model::PlacedDrawing>& drawings, const std::string& name,
                 const std::vector<View>& views) {
  for (model::PlacedDrawing& drawing : drawings)
    if (std::count(views.begin(), views.end(), drawing.view) != 0)
      std::erase_if(drawing.paths, [&](const auto& path) { return path.name == name; });
}

TEST_F(SketchCommand, MakesTheCarAgainThatWasDrawn) {
  write_views("views.svg", drawn());
  const auto report = json({"sketch", "views.svg", "-o", "car.toml", "--json"});
  EXPECT_TRUE(report.at("missing").empty());
  EXPECT_LT(farthest_point("car.toml"), round_trip_error);
  expect_smooth("car.toml");
}

TEST_F(SketchCommand, MakesItFromAFileForEachView) {
  std::string views;
  const Vector2d origin(120.0, 340.0);
  for (const model::PlacedDrawing& drawing : drawn()) {
    const std::string name = model::view_name(drawing.view);
    const double scale = 4.0 + double(drawing.paths.size()) / 8.0;
    model::Drawing page;
    for (const model::DrawnPath& path : drawing.paths)
      page.paths.push_back(placed(path, "lines", scale, origin));
    io::write_svg_drawing(page, file(name + ".svg"));
    // Points of an SVG file have their y downwards.
    views += "[views." + name + "]\nfile = \"" + name +
             ".svg\"\nlayer = \"lines\"\nscale = " + std::to_string(scale) +
             "\norigin = [120.0, -340.0]\n";
  }
  write("views.toml", "tolerance = 8.0\n" + views);
  EXPECT_EQ(bodyline({"sketch", "views.toml", "-o", "car.toml"}).exit_code, 0);
  EXPECT_LT(farthest_point("car.toml"), round_trip_error);
}

TEST_F(SketchCommand, TakesWhatItWritesAsTemplate) {
  ASSERT_EQ(bodyline({"sketch", "--template", car("model1"), "-o", "views.svg"}).exit_code, 0);
  const auto run = bodyline({"sketch", "views.svg", "-o", "car.toml"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(farthest_point("car.toml"), 0.2);  // pieces of quintics are within 0.05 mm
}

TEST_F(SketchCommand, FollowsTransformsAndMirroredLayers) {
  const auto drawings = drawn();
  write_views("views.svg", drawings);
  std::string turned = text("views.svg");
  const auto transform = [&](const std::string& layer, const std::string& how) {
    const std::string mark = "id=\"layer-" + layer + "\"";
    const std::size_t at = turned.find(mark);
    ASSERT_NE(at, turned.npos);
    turned.replace(at, mark.size(), mark + " transform=\"" + how + "\"");
  };
  transform("side", "translate(9000,40) scale(-1,1)");  // the nose to the right
  transform("top", "rotate(90) scale(0.5)");            // the nose upwards, at half the size
  transform("front", "matrix(2 0 0 2 -70 30)");
  write("turned.svg", turned);
  ASSERT_EQ(bodyline({"sketch", "views.svg", "-o", "a.toml"}).exit_code, 0);
  const auto run = bodyline({"sketch", "turned.svg", "-o", "b.toml"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const model::Model a = io::read_model(file("a.toml")), b = io::read_model(file("b.toml"));
  // The search ends where the sum of squares gains no more than 1e-7 of it.
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    EXPECT_LT(testing::largest_move(a.curves[c], b.curves[c]), 0.05) << a.curves[c].name;
}

TEST_F(SketchCommand, ListsWhatIsNotDrawnAndWhatIsDrawnInOneViewOnly) {
  auto drawings = drawn();
  remove_path(drawings, "windshield__side_window", model::all_views());
  remove_path(drawings, "rear_arch_rear", {View::top, View::front, View::rear});
  write_views("views.svg", drawings);
  const auto run = bodyline({"sketch", "views.svg", "-o", "car.toml"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("Not drawn, the template's brought to size: "
                                 "windshield__side_window\n"));
  EXPECT_THAT(run.out, HasSubstr("so partly the template's: rear_arch_rear\n"));
  EXPECT_THAT(text("car.toml"), HasSubstr("template, brought to size"));
}

TEST_F(SketchCommand, SuggestsTheNearestNameForAnUnknownOne) {
  auto drawings = drawn();
  for (auto& drawing : drawings)
    for (auto& path : drawing.paths)
      if (path.name == "door_bottom") path.name = "dor_bottom";
  write_views("views.svg", drawings);
  const auto run = bodyline({"sketch", "views.svg", "-o", "car.toml"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("bodyline: warning: the path 'dor_bottom' is left out: no curve "
                                 "has its name; the nearest is 'door_bottom'\n"));
  EXPECT_THAT(run.out, HasSubstr("brought to size: door_bottom\n"));
}

TEST_F(SketchCommand, EndsWithExitCode1WhereViewsDisagree) {
  auto drawings = drawn();
  for (auto& drawing : drawings)
    for (auto& path : drawing.paths)
      if (drawing.view == View::front && path.name == "roof__side_window")
        path = placed(path, "", 1.0, {0.0, 40.0});
  write_views("views.svg", drawings);
  const auto run = bodyline({"sketch", "views.svg", "-o", "car.toml"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("roof__side_window: a tenth of what the views side and top "
                                       "tell together is"),
                             HasSubstr("the view front is the one in doubt.")));
  EXPECT_EQ(
      bodyline({"sketch", "views.svg", "-o", "b.toml", "--tolerance", "roof__side_window=100"})
          .exit_code,
      0);
}

TEST_F(SketchCommand, GivesCurvesTheDegreeThatIsAskedFor) {
  write_views("views.svg", drawn());
  write("views.toml",
        "degree = 4\n[curves.door_bottom]\ndegree = 6\n[views.side]\nfile = \"views.svg\"\nlayer = "
        "\"side\"\n[views.top]\nfile = \"views.svg\"\nlayer = \"top\"\n");
  const auto degrees = [](const nlohmann::json& report) {
    std::map<std::string, int> found;
    for (const auto& curve : report.at("curves")) found[curve.at("curve")] = curve.at("degree");
    return found;
  };
  auto found = degrees(json({"sketch", "views.toml", "-o", "a.toml", "--json"}));
  EXPECT_EQ(found.at("door_bottom"), 6);
  EXPECT_EQ(found.at("roof__side_window"), 6);  // opposite to it
  EXPECT_EQ(found.at("grille_bottom"), 4);
  found = degrees(json({"sketch", "views.toml", "-o", "b.toml", "--json", "--degree", "5"}));
  for (const auto& [curve, degree] : found) EXPECT_EQ(degree, 5) << curve;
}

TEST_F(SketchCommand, TakesDegreesFromTheNamesInTheDrawing) {
  ASSERT_EQ(bodyline({"sketch", "--template", car("model1"), "-o", "views.svg"}).exit_code, 0);
  std::string drawing = text("views.svg");
  const auto rename = [&](const std::string& name, const std::string& other) {
    const std::string label = "inkscape:label=\"";
    const std::size_t at = drawing.find(label + name + "\"");
    ASSERT_NE(at, drawing.npos) << name;
    drawing.replace(at, label.size() + name.size(), label + other);
  };
  rename("roof__side_window [degree 5]", "roof__side_window [degree 6]");
  rename("grille_bottom", "grille_bottom [degree 4]-2");
  write("drawn.svg", drawing);
  const auto degrees = [&](std::vector<std::string> options) {
    std::vector<std::string> command{"sketch",   "drawn.svg", "-o",
                                     "car.toml", "--json",    "--overwrite"};
    command.insert(command.end(), options.begin(), options.end());
    std::map<std::string, int> found;
    const auto report = json(command);
    EXPECT_TRUE(report.at("missing").empty());
    for (const auto& curve : report.at("curves")) found[curve.at("curve")] = curve.at("degree");
    return found;
  };
  auto found = degrees({});
  EXPECT_EQ(found.at("roof__side_window"), 6);
  EXPECT_EQ(found.at("door_bottom"), 6);  // opposite to it
  EXPECT_EQ(found.at("grille_bottom"), 4);
  EXPECT_EQ(found.at("rear_arch_rear"), 3);
  found = degrees({"--degree", "door_bottom=7"});  // the command line counts before the drawing
  EXPECT_EQ(found.at("roof__side_window"), 7);
  EXPECT_EQ(found.at("grille_bottom"), 4);
  found = degrees({"--degree", "5"});
  for (const auto& [curve, degree] : found) EXPECT_EQ(degree, 5) << curve;
}

}  // namespace
}  // namespace bodyline
