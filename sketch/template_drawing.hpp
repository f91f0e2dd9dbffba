#pragma once

#include <string>
#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

namespace bodyline::sketch {

/// A word that stands above a view.
struct ViewTitle {
  std::string text, layer;
  Eigen::Vector2d at{0.0, 0.0};
};

struct TemplateDrawing {
  model::Drawing drawing;  ///< its unit is 1 mm of the car; layers are the views
  std::vector<ViewTitle> titles;
  std::vector<std::string> guides;  ///< layers that are not meant to be changed
};

/// The curves of a body in four views beside each other, each curve in the views that see it and in
/// as many more as it takes to tell its shape in space. Curves up to degree 3 are exact, others
/// within 0.05 mm. Where a degree is not 3, the first path of the first of the curves that must
/// have one degree says so behind its name. A guide layer in each view holds its axes and, without
/// names, all other lines.
TemplateDrawing template_drawing(const model::Model& model);

}  // namespace bodyline::sketch
