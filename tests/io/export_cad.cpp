#include <gtest/gtest.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>

#include "export_house.hpp"
#include "export_read_back.hpp"
#include "io/export_step.hpp"

namespace bodyline {
namespace {

using namespace test;
using model::Surface;

TEST(StepFile, ReadsBackAsTheSameNamedFacesInOneShell) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const auto house = make_house(seed);
    expect_same_faces(house, read_step(io::step_file(house, "house").text));
  }
}

TEST(IgesFile, ReadsBackAsTheSameNamedFacesInOneShell) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const auto house = make_house(seed);
    expect_same_faces(house, read_iges(io::iges_file(house, "house").text));
  }
}

TEST(StepFile, SharesEveryCurveOfAClosedBody) {
  const TopoDS_Shape shape = read_step(io::step_file(make_house(), "house").text).shape;
  EXPECT_EQ(edges_by_faces(shape), (std::map<int, int>{{2, 16}}));
}

TEST(StepFile, LeavesOnlyFreeCurvesOpen) {
  const TopoDS_Shape shape = read_step(io::step_file(make_open_house(), "house").text).shape;
  EXPECT_EQ(edges_by_faces(shape), (std::map<int, int>{{1, 4}, {2, 12}}));
}

TEST(IgesFile, LeavesOnlyFreeCurvesOpen) {
  const TopoDS_Shape shape = read_iges(io::iges_file(make_open_house(), "house").text).shape;
  EXPECT_EQ(edges_by_faces(shape), (std::map<int, int>{{1, 4}, {2, 12}}));
}

TEST(StepFile, EnclosesTheVolumeOfTheFaces) {
  const auto house = make_house();
  GProp_GProps properties;
  BRepGProp::VolumeProperties(read_step(io::step_file(house, "house").text).shape, properties,
                              1e-6);
  // 1e-3 mm of the Gregory face's 0.8 m^2, and the integration's own relative 1e-6.
  EXPECT_NEAR(properties.Mass(), enclosed_volume(house), 800.0 + 1e-6 * enclosed_volume(house));
}

TEST(StepFile, NamesTheFacesThatAreApproximated) {
  const io::CadFile file = io::step_file(make_house(), "house");
  EXPECT_EQ(file.not_polynomial, std::vector<std::string>{"front"});
  EXPECT_GT(file.max_deviation_mm, 0.0);
  EXPECT_LE(file.max_deviation_mm, approximate_mm);
}

TEST(StepFile, MakesOneShellOfEveryConnectedPart) {
  auto faces = make_house();
  for (Surface far : make_open_house(2)) {
    for (auto& p : far.net) p.x() += 3000.0;
    far.name += "_far";
    faces.push_back(far);
  }
  const ReadBack back = read_step(io::step_file(faces, "two houses").text);
  EXPECT_EQ(count_shells(back.shape), 2);
  EXPECT_EQ(back.faces.size(), 17u);
}

TEST(StepFile, SurvivesAnAwkwardProductName) {
  const ReadBack back = read_step(io::step_file(make_house(), "it's a \\ \"house\" \xc3\xa4").text);
  EXPECT_EQ(back.faces.size(), 9u);
}

}  // namespace
}  // namespace bodyline
