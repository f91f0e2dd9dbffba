#include "sketch/visible_curves.hpp"

#include <algorithm>
#include <array>

#include "model/build.hpp"
#include "sketch/combine_views.hpp"
#include "sketch/curve_pieces.hpp"
#include "sketch/line_state.hpp"

namespace bodyline::sketch {
namespace {

using model::View;

constexpr double facing = 0.15;         // cosine to the eye from which on a patch is seen
constexpr double ample_advance = 0.35;  // along the shared axis, for a pair of views that will do

Eigen::Vector3d normal_at(const model::Surface& face, model::Side side) {
  switch (side) {
    case model::Side::u0:
      return outward_normal(face, 0.0, 0.5);
    case model::Side::u1:
      return outward_normal(face, 1.0, 0.5);
    case model::Side::v0:
      return outward_normal(face, 0.5, 0.0);
    case model::Side::v1:
      break;
  }
  return outward_normal(face, 0.5, 1.0);
}

// How well two views tell the shape of a curve: 0 when they do not.
double advance_of(const model::Curve& curve, View a, View b) {
  std::vector<SketchLine> lines;
  for (const View view : {a, b}) {
    const auto picture = projected(view, curve.points);
    lines.push_back(sketch_line({0, view, {"", "", curve_pieces(picture), false}}));
    if (!(lines.back().length > 0.0)) return 0.0;
  }
  const auto combined = combine_views(lines, is_central(curve));
  return combined ? combined->advance : 0.0;
}

void add_best_pair(const model::Curve& curve, std::vector<View>& views) {
  double best = 0.0;
  std::array<View, 2> pair{View::side, View::top};
  for (const View a : model::all_views()) {
    for (const View b : model::all_views()) {
      if (b <= a) continue;
      const double advance = advance_of(curve, a, b);
      const bool drawn = std::count(views.begin(), views.end(), a) != 0 &&
                         std::count(views.begin(), views.end(), b) != 0;
      if (drawn && advance >= ample_advance) return;
      if (advance > best) best = advance, pair = {a, b};
    }
  }
  for (const View view : pair)
    if (std::count(views.begin(), views.end(), view) == 0) views.push_back(view);
}

}  // namespace

std::vector<std::vector<View>> visible_curves(const model::Model& model) {
  const std::vector<model::Surface> faces =
      model::build(model, model::Stage::base, model::Halves::left_and_central);
  std::vector<std::vector<View>> visible(model.curves.size());
  for (const View view : model::all_views()) {
    const Eigen::Vector3d toward = model::view_axes(view).toward;
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
      for (const model::Side side : model::all_sides) {
        std::vector<View>& views = visible[model.patches[p].sides[std::size_t(side)].curve];
        if (normal_at(faces[p], side).dot(toward) > facing &&
            std::count(views.begin(), views.end(), view) == 0)
          views.push_back(view);
      }
    }
  }
  for (std::size_t c = 0; c < visible.size(); ++c) add_best_pair(model.curves[c], visible[c]);
  return visible;
}

}  // namespace bodyline::sketch
