#include <gtest/gtest.h>

#include <unistd.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Surface.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <STEPControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "export_house.hpp"
#include "io/export_shell.hpp"
#include "io/export_step.hpp"

namespace bodyline {
namespace {

using namespace test;
using model::Surface;

// The files hold 15 digits: 1e-12 mm at 1 m; the law of the product is 1e-6 for exact faces, 1e-3
// for others.
constexpr double exact_mm = 1e-6, approximate_mm = 1e-3;

/// What comes back from a file: the whole shape and its faces by name.
struct ReadBack {
  TopoDS_Shape shape;
  std::map<std::string, TopoDS_Face> faces;
};

template <typename Reader>
void read_shape(Reader& reader, const std::string& text, const char* extension, ReadBack& back) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("bodyline_cad_" + std::to_string(::getpid()) + extension);
  std::ofstream(path, std::ios::binary) << text;
  const io::QuietCad quiet;
  EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  back.shape = reader.OneShape();
  std::filesystem::remove(path);
}

ReadBack read_step(const std::string& text) {
  ReadBack back;
  STEPControl_Reader reader;
  read_shape(reader, text, ".step", back);
  for (TopExp_Explorer at(back.shape, TopAbs_FACE); at.More(); at.Next()) {
    const auto entity = reader.WS()->TransferReader()->EntityFromShapeResult(at.Current(), 1);
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
    EXPECT_FALSE(item.IsNull());
    if (!item.IsNull()) back.faces[item->Name()->ToCString()] = TopoDS::Face(at.Current());
  }
  return back;
}

ReadBack read_iges(const std::string& text) {
  ReadBack back;
  IGESControl_Reader reader;
  read_shape(reader, text, ".igs", back);
  for (TopExp_Explorer at(back.shape, TopAbs_FACE); at.More(); at.Next()) {
    const auto entity = reader.WS()->TransferReader()->EntityFromShapeResult(at.Current(), 1);
    const auto item = Handle(IGESData_IGESEntity)::DownCast(entity);
    EXPECT_FALSE(item.IsNull());
    if (!item.IsNull()) back.faces[item->NameValue()->ToCString()] = TopoDS::Face(at.Current());
  }
  return back;
}

/// Largest distance between equal parameters of a face and of what was read.
double deviation(const Surface& surface, const TopoDS_Face& face) {
  const Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);
  double largest = 0.0;
  constexpr int samples = 40;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) {
      const double u = std::pow(i / double{samples}, 2), v = std::pow(j / double{samples}, 2);
      const gp_Pnt p = geometry->Value(u, v);
      largest = std::max(
          largest,
          (model::jet(surface, u, v, 0).d[0] - Eigen::Vector3d(p.X(), p.Y(), p.Z())).norm());
    }
  return largest;
}

/// Edges by the number of faces around them; degenerate ones left out. Both faces must run along
/// them in opposite directions.
std::map<int, int> edges_by_faces(const TopoDS_Shape& shape) {
  std::map<int, int> count;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int k = 1; k <= faces_of.Extent(); ++k)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(faces_of.FindKey(k)))) ++count[faces_of(k).Extent()];
  return count;
}

int forward_minus_reversed(const TopoDS_Shape& shape) {
  std::map<int, int> balance;
  for (TopExp_Explorer at(shape, TopAbs_EDGE); at.More(); at.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(at.Current())))
      balance[at.Current().HashCode(1 << 30)] +=
          at.Current().Orientation() == TopAbs_FORWARD ? 1 : -1;
  int unbalanced = 0;
  for (const auto& [edge, sum] : balance) unbalanced += sum != 0;
  return unbalanced;
}

int shells(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer at(shape, TopAbs_SHELL); at.More(); at.Next()) ++count;
  return count;
}

void expect_faces(const std::vector<Surface>& surfaces, const ReadBack& back) {
  ASSERT_EQ(back.faces.size(), surfaces.size());
  for (const Surface& surface : surfaces) {
    ASSERT_TRUE(back.faces.count(surface.name)) << surface.name;
    EXPECT_LE(deviation(surface, back.faces.at(surface.name)),
              surface.blend ? approximate_mm : exact_mm)
        << surface.name;
  }
  EXPECT_EQ(shells(back.shape), 1);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape).IsValid());
}

TEST(StepFile, ReadsBackAsTheSameNamedFacesInOneShell) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const auto house = make_house(seed);
    expect_faces(house, read_step(io::step_file(house, "house").text));
  }
}

TEST(IgesFile, ReadsBackAsTheSameNamedFacesInOneShell) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const auto house = make_house(seed);
    expect_faces(house, read_iges(io::iges_file(house, "house").text));
  }
}

TEST(StepFile, SharesEveryCurveOfAClosedBody) {
  const TopoDS_Shape shape = read_step(io::step_file(make_house(), "house").text).shape;
  EXPECT_EQ(edges_by_faces(shape), (std::map<int, int>{{2, 16}}));
  EXPECT_EQ(forward_minus_reversed(shape), 0);
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
  EXPECT_EQ(shells(back.shape), 2);
  EXPECT_EQ(back.faces.size(), 17u);
}

TEST(StepFile, SurvivesAnAwkwardProductName) {
  const ReadBack back = read_step(io::step_file(make_house(), "it's a \\ \"house\" \xc3\xa4").text);
  EXPECT_EQ(back.faces.size(), 9u);
}

}  // namespace
}  // namespace bodyline
