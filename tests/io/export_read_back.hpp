#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <string>
#include <vector>

#include "model/surface.hpp"

/// CAD files read back with OpenCASCADE.
namespace bodyline::test {

// The files hold 16 digits: 1e-12 mm at 5 m; what the product promises is 1e-6 mm for exact faces,
// 1e-3 for others.
inline constexpr double exact_mm = 1e-6, approximate_mm = 1e-3;

/// What comes back from a file: the whole shape and its faces by name.
struct ReadBack {
  TopoDS_Shape shape;
  std::map<std::string, TopoDS_Face> faces;
};

ReadBack read_step(const std::string& text);
ReadBack read_iges(const std::string& text);

/// How many edges lie between how many faces; degenerate ones are left out.
std::map<int, int> edges_by_faces(const TopoDS_Shape& shape);

/// Edges between two faces that run along them in the same direction, so that the faces look to
/// opposite sides.
int twisted_edges(const TopoDS_Shape& shape);

int count_shells(const TopoDS_Shape& shape);

/// Expects the same faces by name, in place, looking outwards, in one valid shell.
void expect_same_faces(const std::vector<model::Surface>& surfaces, const ReadBack& back);

}  // namespace bodyline::test
