#include "sketch/template_drawing.hpp"

#include <algorithm>

#include "sketch/curve_pieces.hpp"
#include "sketch/drawn_degrees.hpp"
#include "sketch/gather_strokes.hpp"
#include "sketch/line_state.hpp"
#include "sketch/visible_curves.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;
using model::View;

constexpr double room = 500.0;  // mm between views
constexpr int usual_degree = 3;

Vector2d rounded(const Vector2d& point) {
  return (point * 1000.0).array().round().matrix() / 1000.0;
}

model::DrawnPath drawn(View view, const model::Curve& curve, bool mirrored, const Vector2d& place) {
  model::DrawnPath path;
  std::vector<Eigen::Vector3d> points = curve.points;
  if (mirrored)
    for (Eigen::Vector3d& point : points) point.y() = -point.y();
  path.segments = curve_pieces(projected(view, points));
  for (model::CubicSegment& segment : path.segments)
    for (Vector2d& point : segment.points) point = rounded(point + place);
  return path;
}

// A curve seen end on, as a dot, is not drawn.
bool is_seen(const model::DrawnPath& path) {
  return model::drawn_box({&path, 1}).diagonal().norm() > 1.0;
}

// Side in the middle, front to its left, rear to its right, top above, so that each coordinate lies
// at the same place in the views that share it.
Vector2d place_of(View view, const Eigen::AlignedBox3d& box) {
  if (view == View::front) return {box.min().x() - room + box.min().y(), 0.0};
  if (view == View::rear) return {box.max().x() + room - box.min().y(), 0.0};
  if (view == View::top) return {0.0, box.max().z() + room - box.min().y()};
  return {0.0, 0.0};
}

Eigen::AlignedBox3d box_of(const model::Model& model) {
  Eigen::AlignedBox3d box;
  for (const model::Curve& curve : model.curves)
    for (const Eigen::Vector3d& point : curve.points)
      box.extend(point).extend(Eigen::Vector3d(point.x(), -point.y(), point.z()));
  return box;
}

model::DrawnPath axes(const std::string& layer, const Vector2d& origin) {
  constexpr double leg = model::axes_length;
  return {model::axes_name,
          layer,
          {model::line_segment(origin + Vector2d(leg, 0.0), origin),
           model::line_segment(origin, origin + Vector2d(0.0, leg))},
          false};
}

}  // namespace

TemplateDrawing template_drawing(const model::Model& model) {
  const std::vector<std::vector<View>> visible = visible_curves(model);
  const Eigen::AlignedBox3d box = box_of(model);
  std::vector<int> unnamed_degrees = degree_classes(model);  // -1 once a class has said its own
  TemplateDrawing result;
  result.drawing.unit_mm = 0.1;  // a tenth of the car on paper
  for (const View view : model::all_views()) {
    const std::string layer = model::view_name(view), guide = layer + "/guide";
    const Vector2d place = rounded(place_of(view, box));
    result.guides.push_back(guide);
    std::vector<model::DrawnPath>& paths = result.drawing.paths;
    paths.push_back(axes(guide, place));
    const std::size_t first = paths.size();
    std::vector<model::DrawnPath> named;
    for (std::size_t c = 0; c < model.curves.size(); ++c) {
      const model::Curve& curve = model.curves[c];
      model::DrawnPath path = drawn(view, curve, false, place);
      if (!is_seen(path)) continue;
      const bool shown = std::count(visible[c].begin(), visible[c].end(), view) != 0;
      path.layer = shown ? layer : guide;
      if (shown) path.name = curve.name;
      const int degree = int(curve.points.size()) - 1, of_class = unnamed_degrees[c];
      if (shown && degree != usual_degree && of_class >= 0) {
        path.name = name_with_degree(curve.name, degree);
        std::replace(unnamed_degrees.begin(), unnamed_degrees.end(), of_class, -1);
      }
      (shown ? named : paths).push_back(std::move(path));
      if (view == View::side || is_central(curve) || !shown) continue;
      paths.push_back(drawn(view, curve, true, place));
      paths.back().layer = guide;
    }
    paths.insert(paths.end(), named.begin(), named.end());
    const Eigen::AlignedBox2d extent =
        model::drawn_box({paths.data() + first, paths.size() - first});
    result.titles.push_back({layer, guide, {extent.min().x(), extent.max().y() + 0.3 * room}});
  }
  return result;
}

}  // namespace bodyline::sketch
