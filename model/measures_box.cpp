#include <algorithm>
#include <stdexcept>

#include "model/measures.hpp"
#include "model/measures_furthest.hpp"

namespace bodyline::model {

Box bounding_box(const std::vector<Surface>& faces, Halves halves) {
  if (faces.empty()) throw std::invalid_argument("a body without faces has no size");
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = furthest_point(faces, axis, -1.0).value;
    box.high[axis] = furthest_point(faces, axis, 1.0).value;
  }
  if (halves == Halves::left_and_central) {
    const double half_width = std::max(-box.low.y(), box.high.y());
    box.low.y() = -half_width;
    box.high.y() = half_width;
  }
  return box;
}

}  // namespace bodyline::model
