#include "io/drawing_axes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using model::View;

constexpr double careless = 0.01;  // of the length of the lines

[[noreturn]] void refuse(View view) {
  throw std::invalid_argument(
      "the path \"axes\" of the view " + model::view_name(view) +
      " does not lie as it should: it leads from 1000 mm to the right of the origin to the origin "
      "and on to 1000 mm above it, square and to scale");
}

// Where the axis to the right of a view points on a page whose nose points so; the axis upwards is
// square to it, and mirrored with it in a side view.
Vector2d right_on_page(View view, Nose nose) {
  if (view == View::side) return {nose == Nose::right ? -1.0 : 1.0, 0.0};
  switch (nose) {
    case Nose::right:
      return {-1.0, 0.0};
    case Nose::up:
      return {0.0, -1.0};
    case Nose::down:
      return {0.0, 1.0};
    case Nose::left:
      break;
  }
  return {1.0, 0.0};
}

Vector2d up_on_page(View view, const Vector2d& right) {
  return view == View::side ? Vector2d(0.0, 1.0) : Vector2d(-right.y(), right.x());
}

}  // namespace

void take_axes(ViewDrawing& view) {
  auto& paths = view.drawing.paths;
  const auto found = std::find_if(paths.begin(), paths.end(), [](const model::DrawnPath& path) {
    return path.name == model::axes_name;
  });
  if (found == paths.end()) return;
  if (found->segments.size() != 2) refuse(view.view);
  const Vector2d origin = found->segments[0].points[3];
  const Vector2d right = found->segments[0].points[0] - origin;
  const Vector2d up = found->segments[1].points[3] - origin;
  const double length = right.norm();
  bool explained = false;
  for (const Nose nose : {Nose::left, Nose::right, Nose::up, Nose::down}) {
    if (!nose_fits(view.view, nose)) continue;
    const Vector2d wanted = right_on_page(view.view, nose);
    if ((right - length * wanted).norm() > careless * length) continue;
    if ((up - length * up_on_page(view.view, wanted)).norm() > careless * length) continue;
    view.nose = nose;
    explained = true;
  }
  if (!explained) refuse(view.view);
  if (!view.scale) view.scale = model::axes_length / length;
  if (!view.origin) view.origin = origin;
  paths.erase(found);
}

}  // namespace bodyline::io
