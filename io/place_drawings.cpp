#include "io/place_drawings.hpp"

#include <stdexcept>

#include "io/view_scales.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using model::View;

// Turns a page so that the nose points to the left: the side view is mirrored, since a nose to the
// right shows the right side of the car; the top view is turned.
Eigen::Matrix2d turned(View view, Nose nose) {
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  if (view == View::side && nose == Nose::right) turn(0, 0) = -1.0;
  if (view != View::top) return turn;
  if (nose == Nose::right) turn = -turn;
  if (nose == Nose::up) turn << 0, -1, 1, 0;
  if (nose == Nose::down) turn << 0, 1, -1, 0;
  return turn;
}

std::vector<model::DrawnPath> moved(std::vector<model::DrawnPath> paths,
                                    const Eigen::Affine2d& move) {
  for (model::DrawnPath& path : paths)
    for (model::CubicSegment& segment : path.segments)
      for (Vector2d& point : segment.points) point = move * point;
  return paths;
}

// Where the lower left corner of a drawing comes to lie, or the middle of its lower edge.
Vector2d anchor(View view, const Eigen::AlignedBox3d& body) {
  if (view == View::side) return {body.min().x(), body.min().z()};
  if (view == View::top) return {body.min().x(), 0.0};
  return {0.0, body.min().z()};
}

Vector2d anchored_point(View view, const Eigen::AlignedBox2d& box) {
  if (view == View::side) return box.min();
  if (view == View::top) return {box.min().x(), box.center().y()};
  return {box.center().x(), box.min().y()};
}

}  // namespace

PlacedViews place_drawings(const std::vector<ViewDrawing>& views, const PlaceOptions& options) {
  std::vector<DrawnSize> sizes;
  std::vector<std::vector<model::DrawnPath>> upright;
  for (const ViewDrawing& view : views) {
    if (!nose_fits(view.view, view.nose))
      throw std::invalid_argument("the nose does not point " + nose_name(view.nose) +
                                  " in a view " + view_name(view.view));
    upright.push_back(moved(view.drawing.paths, Eigen::Affine2d(turned(view.view, view.nose))));
    const Eigen::AlignedBox2d box = model::drawn_box(upright.back());
    if (box.isEmpty())
      throw std::invalid_argument("nothing is drawn in the view " + view_name(view.view));
    sizes.push_back({view.view, box.sizes(), view.drawing.unit_mm, view.scale});
  }
  ViewScales found = view_scales(std::move(sizes), {options.length, options.width, options.height});
  PlacedViews placed;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const ViewDrawing& view = views[v];
    Eigen::Affine2d move(Eigen::Scaling(found.scales[v]));
    if (view.origin) {
      move.translation() = -(move.linear() * (turned(view.view, view.nose) * *view.origin));
    } else {
      const Vector2d at = anchored_point(view.view, model::drawn_box(upright[v]));
      move.translation() = anchor(view.view, options.body) - move.linear() * at;
    }
    placed.moves.push_back(move * Eigen::Affine2d(turned(view.view, view.nose)));
    placed.drawings.push_back({view.view, moved(std::move(upright[v]), move)});
  }
  placed.scales = std::move(found.scales);
  placed.size = found.size;
  placed.notes = std::move(found.notes);
  return placed;
}

}  // namespace bodyline::io
