#include "export_read_back.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <STEPControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/export_shell.hpp"

namespace bodyline::test {
namespace {

using model::Surface;

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

/// Largest distance between equal parameters of a face and of what was read; finer towards (0,0),
/// where the Gregory term is not smooth.
double deviation(const Surface& surface, const Handle(Geom_Surface) & geometry) {
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

/// The cosine between the normal that was read and the face's own outward one, in the middle.
double outward_cosine(const Surface& surface, const TopoDS_Face& face) {
  gp_Pnt p;
  gp_Vec du, dv;
  BRep_Tool::Surface(face)->D1(0.5, 0.5, p, du, dv);
  gp_Vec normal = du.Crossed(dv).Normalized();
  if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
  return model::outward_normal(surface, 0.5, 0.5)
      .dot(Eigen::Vector3d(normal.X(), normal.Y(), normal.Z()));
}

}  // namespace

ReadBack read_step(const std::string& text) {
  ReadBack back;
  STEPControl_Reader reader;
  read_shape(reader, text, ".step", back);
  for (TopExp_Explorer at(back.shape, TopAbs_FACE); at.More(); at.Next()) {
    const auto entity = reader.WS()->TransferReader()->EntityFromShapeResult(at.Current(), 1);
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
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
    if (!item.IsNull() && item->HasName())
      back.faces[item->NameValue()->ToCString()] = TopoDS::Face(at.Current());
  }
  return back;
}

std::map<int, int> edges_by_faces(const TopoDS_Shape& shape) {
  std::map<int, int> count;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int k = 1; k <= faces_of.Extent(); ++k)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(faces_of.FindKey(k)))) ++count[faces_of(k).Extent()];
  return count;
}

int twisted_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  std::map<int, std::pair<int, int>> uses;  // how often an edge is used, and forward less reversed
  for (TopExp_Explorer at(shape, TopAbs_EDGE); at.More(); at.Next()) {
    auto& [count, balance] = uses[edges.Add(at.Current())];
    ++count;
    balance += at.Current().Orientation() == TopAbs_FORWARD ? 1 : -1;
  }
  int twisted = 0;
  for (const auto& [edge, use] : uses) twisted += use.first == 2 && use.second != 0;
  return twisted;
}

int count_shells(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer at(shape, TopAbs_SHELL); at.More(); at.Next()) ++count;
  return count;
}

void expect_same_faces(const std::vector<Surface>& surfaces, const ReadBack& back) {
  EXPECT_EQ(back.faces.size(), surfaces.size());
  for (const Surface& surface : surfaces) {
    ASSERT_TRUE(back.faces.count(surface.name)) << surface.name;
    const TopoDS_Face& face = back.faces.at(surface.name);
    EXPECT_LE(deviation(surface, BRep_Tool::Surface(face)),
              surface.blend ? approximate_mm : exact_mm)
        << surface.name;
    EXPECT_GT(outward_cosine(surface, face), 0.99) << surface.name;
  }
  EXPECT_EQ(count_shells(back.shape), 1);
  EXPECT_EQ(twisted_edges(back.shape), 0);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape).IsValid());
}

}  // namespace bodyline::test
