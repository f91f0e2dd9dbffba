#include "strokes/insert_strokes.hpp"

#include <algorithm>
#include <map>

#include "strokes/add_stroke.hpp"
#include "strokes/measure_outcome.hpp"

namespace bodyline::strokes {
namespace {

constexpr double threshold_part = 0.005;  // of the diagonal
constexpr double tolerance_part = 0.2;    // of the threshold

bool holds(const std::vector<int>& members, int number) {
  return std::find(members.begin(), members.end(), number) != members.end();
}

std::vector<StrokeMove> all_moves(const SurfaceBuild& build) {
  std::vector<StrokeMove> moves;
  for (const StrokeOutcome& outcome : build.outcomes)
    moves.insert(moves.end(), outcome.moves.begin(), outcome.moves.end());
  return moves;
}

}  // namespace

double usual_threshold(const std::vector<Points>& polylines) {
  return threshold_part * diagonal(polylines);
}

double usual_tolerance(double threshold_mm) { return tolerance_part * threshold_mm; }

void insert_strokes(SurfaceBuild& build, const std::vector<model::Stroke>& strokes,
                    const std::vector<int>& left_out, const StrokeOptions& options) {
  std::map<int, std::size_t> outcome_of;  // by the stroke's number
  for (int number = 0; number < static_cast<int>(strokes.size()); ++number) {
    if (holds(left_out, number)) continue;
    outcome_of[number] = build.outcomes.size();
    build.outcomes.push_back(add_stroke(build.surface, strokes[number], number, options));
    for (const StrokeMove& move : build.outcomes.back().moves) {
      const auto moved = outcome_of.find(move.stroke);
      if (moved == outcome_of.end()) continue;
      double& gave_way = build.outcomes[moved->second].gave_way_mm;
      gave_way = std::max(gave_way, move.distance);
    }
  }
}

void measure_deviations(SurfaceBuild& build) {
  const std::vector<StrokeMove> moves = all_moves(build);
  for (StrokeOutcome& outcome : build.outcomes)
    measure_outcome(outcome, build.surface, moves,
                    build.smooth ? GivingWay::nearby : GivingWay::all_along);
}

void make_smooth(SurfaceBuild& build, const SmoothBase& base, const SmoothOptions& options) {
  const std::vector<StrokeMove> moves = all_moves(build);
  SmoothSurface smooth = smooth_surface(build.surface.net, base, moves, options);
  build.surface = SurfaceModel(std::move(smooth.net));
  build.smooth = SmoothReport{options.tolerance_mm, smooth.cells, smooth.fairness, 0.0};
  measure_deviations(build);
}

}  // namespace bodyline::strokes
