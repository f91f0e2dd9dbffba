#pragma once

#include <string>
#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

/// Outlines made for tests.
namespace bodyline::optimize {

model::Model outline_test_car(const std::string& name);

/// A path of straight segments; closed when it ends where it begins.
model::DrawnPath straight_path(const std::vector<Eigen::Vector2d>& points);

/// The outlines of a model at stage body, traced every `spacing` mm.
std::vector<model::PlacedDrawing> traced_outlines(const model::Model& car,
                                                  const std::vector<model::View>& views,
                                                  double spacing = 4.0);

/// The outline of a scanned car in a view, in mm of the scan: its triangles as a mask of 2 mm
/// pixels, traced. `have_mesh` tells whether the scans are there.
bool have_mesh(const std::string& name);
model::PlacedDrawing mask_outline(const std::string& name, model::View view);

}  // namespace bodyline::optimize
