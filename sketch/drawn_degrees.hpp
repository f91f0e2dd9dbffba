#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"
#include "sketch/curve_degrees.hpp"

namespace bodyline::sketch {

/// The name of a path or layer with the degree of its curve: "hood [degree 5]".
std::string name_with_degree(const std::string& name, int degree);

/// Takes degrees off the names of paths and of the layers that they are in, and returns those of
/// the curves in `model` by name; a path's own counts before those of its layers. Throws
/// std::invalid_argument for brackets that hold no degree from 2 to 9, and for a curve with two
/// degrees.
std::map<std::string, int> take_degrees(const model::Model& model,
                                        std::span<model::PlacedDrawing> drawings);

/// For each curve of a model the first one that must have its degree, since they lie on opposite
/// sides of patches: itself, or one before it.
std::vector<int> degree_classes(const model::Model& model);

/// The degrees with those that are drawn, unless they are for all curves; no curve's that is named
/// there, or that must have the degree of one that is.
CurveDegrees with_drawn_degrees(const model::Model& model, CurveDegrees degrees,
                                const std::map<std::string, int>& drawn);

}  // namespace bodyline::sketch
