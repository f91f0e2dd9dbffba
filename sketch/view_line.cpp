#include "sketch/view_line.hpp"

#include <algorithm>

#include "sketch/join_lines.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;
using model::View;

double length_of(const std::vector<Vector2d>& points) {
  double length = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
  return length;
}

// The left half of a drawing that passes through the plane of symmetry.
std::vector<Vector2d> left_half(View view, const std::vector<Vector2d>& points) {
  const Vector2d y = shown_axis(view, 1);
  std::vector<Vector2d> half;
  if (y.isZero()) {
    // Seen from the side both halves coincide: the drawing may run there and back.
    const auto farthest =
        std::max_element(points.begin(), points.end(), [&](const Vector2d& a, const Vector2d& b) {
          return (a - points.front()).norm() < (b - points.front()).norm();
        });
    half.assign(points.begin(), farthest + 1);
    return half;
  }
  const auto left = [&y](const Vector2d& point) { return y.dot(point) <= 0.0; };
  const auto left_count = std::count_if(points.begin(), points.end(), left);
  const bool mirror = 3 * left_count < std::ptrdiff_t(points.size());  // the right half is drawn
  for (const Vector2d& point : points) {
    if (left(point) == mirror) continue;
    half.push_back(mirror ? Vector2d(point - 2.0 * y.dot(point) * y) : point);
  }
  return half;
}

}  // namespace

Vector2d shown_axis(View view, int axis) {
  const model::ViewAxes axes = model::view_axes(view);
  return {axes.right[axis], axes.up[axis]};
}

std::vector<ViewLine> view_lines(std::span<const SketchLine> lines, bool central) {
  std::vector<ViewLine> found;
  for (const View view : model::all_views()) {
    ViewLine line{view, join_lines(lines, view), 0.0};
    if (central && !line.points.empty()) line.points = left_half(view, line.points);
    line.length = length_of(line.points);
    if (line.points.size() > 1 && line.length > 0.0) found.push_back(std::move(line));
  }
  return found;
}

int shared_axis(View a, View b) {
  int axis = -1, shared = 0;
  for (int k = 0; k < 3; ++k) {
    if (shown_axis(a, k).isZero() || shown_axis(b, k).isZero()) continue;
    axis = k;
    ++shared;
  }
  return shared == 1 ? axis : -1;
}

}  // namespace bodyline::sketch
