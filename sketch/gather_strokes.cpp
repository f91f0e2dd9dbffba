#include "sketch/gather_strokes.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace bodyline::sketch {
namespace {

using model::View;

// "roof__side_window-2" without "-2".
std::string without_number(const std::string& name) {
  const std::size_t dash = name.rfind('-');
  if (dash == name.npos || dash + 1 == name.size()) return name;
  const bool number = name.find_first_not_of("0123456789", dash + 1) == name.npos;
  return number ? name.substr(0, dash) : name;
}

class CurveNames {
 public:
  explicit CurveNames(const model::Model& model) {
    for (std::size_t k = 0; k < model.curves.size(); ++k) indices_[model.curves[k].name] = int(k);
  }

  int find(const std::string& name) const {
    for (const std::string& form : {name, without_number(name)})
      if (const auto found = indices_.find(form); found != indices_.end()) return found->second;
    return -1;
  }

  // By its own name, or by the innermost layer that is named after a curve.
  int curve_of(const model::DrawnPath& path) const {
    int curve = find(path.name);
    if (curve >= 0) return curve;
    std::istringstream layers(path.layer);
    for (std::string layer; std::getline(layers, layer, '/');)
      if (const int named = find(layer); named >= 0) curve = named;
    return curve;
  }

 private:
  std::map<std::string, int> indices_;
};

// Which coordinate of a view's picture shows y, and with which sign; -1 for side.
int y_axis_of(View view, double& sign) {
  const model::ViewAxes axes = model::view_axes(view);
  for (int k = 0; k < 2; ++k) {
    sign = (k == 0 ? axes.right : axes.up).y();
    if (sign != 0.0) return k;
  }
  return -1;
}

void mirror_to_the_left(View view, model::DrawnPath& path) {
  double sign = 0.0;
  const int axis = y_axis_of(view, sign);
  if (axis < 0) return;
  const Eigen::AlignedBox2d box = model::drawn_box({&path, 1});
  if (sign * box.center()[axis] <= 0.0) return;
  for (model::CubicSegment& segment : path.segments)
    for (Eigen::Vector2d& point : segment.points) point[axis] = -point[axis];
}

}  // namespace

bool is_central(const model::Curve& curve) {
  Eigen::Vector3d mirrored = curve.points.back();
  mirrored.y() = -mirrored.y();
  return curve.points.front() == mirrored;
}

int curve_of(const model::Model& model, const model::DrawnPath& path) {
  return CurveNames(model).curve_of(path);
}

GatheredStrokes gather_strokes(const model::Model& model,
                               std::span<const model::PlacedDrawing> drawings) {
  const CurveNames names(model);
  GatheredStrokes gathered;
  for (const model::PlacedDrawing& drawing : drawings) {
    for (const model::DrawnPath& path : drawing.paths) {
      const int curve = names.curve_of(path);
      auto& unknown = gathered.unknown;
      if (curve >= 0) {
        gathered.strokes.push_back({curve, drawing.view, path});
        if (!is_central(model.curves[curve]))
          mirror_to_the_left(drawing.view, gathered.strokes.back().path);
      } else if (!path.name.empty() &&
                 std::find(unknown.begin(), unknown.end(), path.name) == unknown.end()) {
        unknown.push_back(path.name);
      }
    }
  }
  return gathered;
}

}  // namespace bodyline::sketch
