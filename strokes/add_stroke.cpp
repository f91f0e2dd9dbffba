#include "strokes/add_stroke.hpp"

#include <algorithm>

#include "strokes/asked_points.hpp"
#include "strokes/coons_shape.hpp"
#include "strokes/insert_line.hpp"
#include "strokes/piece_line.hpp"
#include "strokes/smooth_stroke.hpp"

namespace bodyline::strokes {
namespace {

// Strokes that begin and end on curves keep one line unless it is far off: any line is a legal
// pre-image.
std::vector<SampleRange> pieces(const PlacedStroke& stroke, const StrokeOptions& options) {
  const bool snapped = stroke.front_hit && stroke.back_hit;
  const SampleRange whole{0, stroke.places.size() - 1};
  if (snapped && bulge(stroke.places, whole).distance <= options.loose_straightness) return {whole};
  return straight_pieces(stroke.places, options.straightness);
}

// The next piece begins where the line of this one passes its last sample.
void insert(NetEdit& edit, PlacedStroke stroke, int number, const StrokeOptions& options,
            StrokeOutcome& outcome) {
  const std::vector<SampleRange> ranges = pieces(stroke, options);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const bool front_on_edge = k > 0 || stroke.front_hit;
    const bool back_on_edge = k + 1 == ranges.size() && stroke.back_hit;
    const PieceLine line = piece_line(edit.net(), stroke, ranges[k], front_on_edge, back_on_edge);
    const Fade fade = options.method == Method::smooth ? Fade::smooth : Fade::linear;
    const LineResult result =
        insert_line(edit, line.from, line.to, line.curve, {number, line.front, line.back, fade});
    stroke.places[ranges[k].last] = place_on(result, line.back);
    ++outcome.lines;
    outcome.ends_extended += line.extended;
    outcome.patches_split += result.patches_split;
    outcome.curves_moved += result.curves_moved;
    outcome.largest_move_mm = std::max(outcome.largest_move_mm, result.largest_move);
    outcome.moves.insert(outcome.moves.end(), result.moves.begin(), result.moves.end());
  }
}

// The fitted stroke may run against the one that was read; both have the same ends.
Points turned_like(const Points& points, const Points& fitted) {
  if (points.front() == fitted.front()) return points;
  return {points.rbegin(), points.rend()};
}

}  // namespace

StrokeOutcome add_stroke(SurfaceModel& surface, const model::Stroke& stroke, int number,
                         const StrokeOptions& options) {
  StrokeOutcome outcome;
  outcome.name = stroke.name;
  outcome.number = number;
  try {
    NetEdit edit(surface.net);
    const bool smooth = options.method == Method::smooth;
    const Points points = smooth ? smooth_stroke(stroke.points, options) : stroke.points;
    const PlacedStroke placed =
        placed_stroke(surface, points, options.threshold_mm, smooth ? Fade::smooth : Fade::linear);
    outcome.points_trimmed = placed.trimmed;
    outcome.end_move_mm = placed.end_move_mm;
    outcome.drawn = placed.points;
    outcome.asked =
        asked_points(turned_like(stroke.points, points), placed.front_cut, placed.back_cut);
    insert(edit, placed, number, options, outcome);
    surface.index.update(surface.net, touched_patches(edit), edit.moved_edges());
    edit.commit();
  } catch (const StrokeRejected& rejected) {
    outcome = {};
    outcome.name = stroke.name;
    outcome.number = number;
    outcome.rejection = rejected.rejection();
  }
  return outcome;
}

}  // namespace bodyline::strokes
