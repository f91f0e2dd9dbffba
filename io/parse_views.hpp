#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/view.hpp"

namespace bodyline::io {

/// Which way the nose points in a drawing as it lies on its page.
enum class Nose { left, right, up, down };

/// A file that draws the car in a view, as an option of the command line names it.
struct ViewFile {
  model::View view = model::View::side;
  std::string path;
  std::optional<double> scale;  ///< mm of the car per unit of the drawing
  Nose nose = Nose::left;       ///< for side left or right; front and rear have none
};

/// Reads the argument of --views: VIEW=FILE[@SCALE][:nose-left|right|up|down] separated by commas,
/// such as "side=side.svg:nose-right,top=top.png@2.5". Throws std::invalid_argument with a sentence
/// for what cannot be read, also when a view is given twice. Files are not looked at.
std::vector<ViewFile> parse_views(const std::string& text);

/// The noses that a drawing of a view may have: two for side, four for top, one for the others.
bool nose_fits(model::View view, Nose nose);
std::string nose_name(Nose nose);
Nose nose_of(const std::string& name);  ///< throws std::invalid_argument listing the names

}  // namespace bodyline::io
