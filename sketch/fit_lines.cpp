#include "sketch/fit_lines.hpp"

#include <algorithm>
#include <cmath>

#include "sketch/follow_drawings.hpp"
#include "sketch/line_rows.hpp"
#include "sketch/line_state.hpp"
#include "sketch/median.hpp"
#include "sketch/speed_tolerance.hpp"
#include "sketch/template_rows.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// By how much the speed of a curve, relative to its length, differs from the template's: at first,
// before anything is known, and for good where the curve is not known in space. For the others
// their lines tell (likely_speed_tolerance).
constexpr double first_speed_error = 0.05, unknown_speed_error = 0.003;

// By how much inner points differ from the template's, relative to the length of the curve, where
// lines tell them, and where they do not.
constexpr double known_shape_error = 0.2, unknown_shape_error = 0.005;

constexpr double least_noise = 0.025;     // mm
constexpr double least_end_error = 1e-4;  // of the length of a line
constexpr int first_weighings = 2, last_weighings = 4;
constexpr int most_rounds = 40;         // of a search
constexpr double small_gain = 1e-7;     // of the sum of squares, relative: ends a search
constexpr int most_contradictions = 4;  // lines of one curve that are left, one after another

/// Where all curves are, and the lines beside them.
struct Position {
  Eigen::VectorXd unknowns;
  std::vector<std::vector<Vector3d>> curves;
  std::vector<LineState> lines;

  std::vector<Vector2d> picture(const SketchLine& line) const {
    return projected(line.view, curves[line.curve]);
  }
};

/// What counts how much while a search lasts.
struct Weights {
  std::vector<LineWeights> lines;
  std::vector<double> speed_tolerances;  ///< by curve, see add_template_rows
};

/// The curves on their way to the lines.
class LinesSearch {
 public:
  LinesSearch(const model::Model& model, const CurveUnknowns& unknowns,
              std::vector<SketchLine> lines, const FitLinesStart& start)
      : model_(model), unknowns_(unknowns), lines_(std::move(lines)), start_(start) {
    now_.unknowns = start.unknowns;
    update_curves(now_);
    update_lengths();
    for (SketchLine& line : lines_) {
      const bool central = is_central(model.curves[line.curve]);
      now_.lines.push_back(begin_line(line, now_.picture(line), central));
    }
  }

  LinesFit run() {
    for (int k = 0; k < first_weighings; ++k) {
      search(weigh(false));
      update_lengths();
    }
    mark_followed(now_);
    Position by_shape = now_;
    for (int k = 0; k < most_contradictions; ++k) {
      follow();
      if (!leave_drawings(now_.lines, errors())) break;
      for (std::size_t l = 0; l < lines_.size(); ++l)
        by_shape.lines[l].follows = now_.lines[l].follows;
      now_ = by_shape;
    }
    return result();
  }

 private:
  void mark_followed(Position& position) const {
    std::vector<double> distances;
    for (const LineErrors& line : errors()) distances.push_back(line.normal);
    follow_drawings(model_, position.lines, distances);
  }

  // Lets curves run along lines as they were drawn where these tell.
  void follow() {
    for (LineState& state : now_.lines)
      if (state.follows) match_drawn(state);
    move_to_drawings();
    search(weigh(false));
    for (int k = 0; k < last_weighings; ++k) search(weigh(true));
  }

  // Goes at once to where the drawings want the curves. What they are like now need not be near, as
  // long as their ends are.
  void move_to_drawings() {
    const Weights weights = weigh(false);
    NormalEquations sums(unknowns_.count() + 2 * int(lines_.size()));
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const LineState& state = now_.lines[k];
      const std::vector<Vector2d> picture = now_.picture(lines_[k]);
      if (state.follows)
        add_drawn_rows(state, picture, 1.0, unknowns_, sums);
      else
        add_line_rows(state, picture, weights.lines[k], unknowns_, column_of(k), sums);
    }
    for (std::size_t c = 0; c < now_.curves.size(); ++c)
      add_template_rows(unknowns_, int(c), now_.curves[c], like(c), first_speed_error, sums);
    now_.unknowns += sums.solution().head(unknowns_.count());
    update_curves(now_);
    for (std::size_t k = 0; k < lines_.size(); ++k)
      find_feet(now_.lines[k], now_.picture(lines_[k]));
  }

  void update_curves(Position& position) const {
    position.curves.clear();
    for (std::size_t c = 0; c < model_.curves.size(); ++c)
      position.curves.push_back(unknowns_.points(int(c), position.unknowns));
  }

  void update_lengths() {
    lengths_.clear();
    for (const auto& points : now_.curves) lengths_.push_back(curve_length(points));
  }

  CurveTemplate like(std::size_t curve) const {
    return {start_.shape[curve], lengths_[curve],
            start_.known[curve] ? known_shape_error : unknown_shape_error};
  }

  std::vector<LineErrors> errors() const {
    std::vector<LineErrors> all;
    for (const LineState& state : now_.lines)
      all.push_back(line_errors(state, now_.picture(*state.line)));
    return all;
  }

  Weights weigh(bool settled) const {
    std::vector<double> distances;
    for (const LineErrors& line : errors()) distances.push_back(line.normal);
    const double noise = std::max(least_noise, normal_deviation * median(distances));
    const double carelessness = end_error();
    Weights weights;
    for (const LineState& state : now_.lines)
      weights.lines.push_back(
          line_weights(state, now_.picture(*state.line), noise, carelessness, settled));
    for (std::size_t c = 0; c < now_.curves.size(); ++c)
      weights.speed_tolerances.push_back(settled ? settled_tolerance(c, weights.lines)
                                                 : first_speed_error);
    return weights;
  }

  // How far lines end from where their curves do, relative to their length.
  double end_error() const {
    std::vector<double> errors;
    for (const LineState& state : now_.lines) {
      if (state.holds_first) errors.push_back(std::abs(state.feet.front()));
      if (state.holds_last) errors.push_back(std::abs(1.0 - state.feet.back()));
    }
    return std::max(least_end_error, normal_deviation * median(errors));
  }

  // A curve that is not known in space keeps the speed of the template: nothing could tell it from
  // a detour in the direction that is not drawn.
  double settled_tolerance(std::size_t curve, const std::vector<LineWeights>& weights) const {
    if (!start_.known[curve]) return unknown_speed_error;
    const int count = unknowns_.count() + 2 * int(lines_.size());
    NormalEquations lines(count), shape(count), speed(count);
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (lines_[k].curve != int(curve)) continue;
      add_line_rows(now_.lines[k], now_.picture(lines_[k]), weights[k], unknowns_, column_of(k),
                    lines);
    }
    add_shape_rows(unknowns_, int(curve), now_.curves[curve], like(curve), shape);
    add_speed_rows(unknowns_, int(curve), now_.curves[curve], like(curve), 1.0, speed);
    return likely_speed_tolerance({lines, shape, speed, unknowns_.count()});
  }

  NormalEquations equations(const Position& position, const Weights& weights) const {
    NormalEquations sums(unknowns_.count() + 2 * int(lines_.size()));
    for (std::size_t k = 0; k < lines_.size(); ++k)
      add_line_rows(position.lines[k], position.picture(lines_[k]), weights.lines[k], unknowns_,
                    column_of(k), sums);
    for (std::size_t c = 0; c < position.curves.size(); ++c)
      add_template_rows(unknowns_, int(c), position.curves[c], like(c), weights.speed_tolerances[c],
                        sums);
    return sums;
  }

  int column_of(std::size_t line) const { return unknowns_.count() + 2 * int(line); }

  Position moved(const Eigen::VectorXd& move) const {
    Position next = now_;
    next.unknowns += move.head(unknowns_.count());
    update_curves(next);
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      next.lines[k].offset += move[column_of(k)];
      next.lines[k].step += move[column_of(k) + 1];
      update_feet(next.lines[k], next.picture(lines_[k]));
    }
    return next;
  }

  // Levenberg and Marquardt: feet held, all curves move at once to where the sum of squares is
  // least; then the feet are found anew.
  void search(const Weights& weights) {
    double damping = 1e-6;
    NormalEquations at = equations(now_, weights);
    for (int round = 0; round < most_rounds && damping < 1e6; ++round) {
      ++rounds_;
      Position next = moved(at.solution(damping));
      NormalEquations there = equations(next, weights);
      const double gain = at.sum() - there.sum();
      damping = gain >= 0.0 ? std::max(damping / 10.0, 1e-12) : std::max(damping, 1e-6) * 10.0;
      if (!(gain >= 0.0)) continue;
      const bool done = gain <= small_gain * at.sum();
      now_ = std::move(next);
      at = std::move(there);
      if (done) return;
    }
  }

  LinesFit result() const {
    LinesFit fit{now_.unknowns, {}, rounds_};
    for (const LineState& state : now_.lines) {
      LineFit line{state.follows, 0.0, 0.0};
      const std::vector<Vector2d> picture = now_.picture(*state.line);
      std::vector<double> distances;
      for (std::size_t k = 0; k < state.feet.size(); ++k) {
        if (!(state.feet[k] > 0.0 && state.feet[k] < 1.0) || !has_foot(state, k)) continue;
        distances.push_back(
            (curve_jet<2>(picture, state.feet[k]).point - state.line->points[k]).norm());
        line.rms += distances.back() * distances.back();
      }
      line.rms = std::sqrt(line.rms / double(std::max<std::size_t>(1, distances.size())));
      line.p90 = quantile(distances, 0.9);
      fit.lines.push_back(line);
    }
    return fit;
  }

  const model::Model& model_;
  const CurveUnknowns& unknowns_;
  std::vector<SketchLine> lines_;
  const FitLinesStart& start_;
  Position now_;
  std::vector<double> lengths_;  // of the curves, once they are known
  int rounds_ = 0;
};

}  // namespace

LinesFit fit_lines(const model::Model& model, const CurveUnknowns& unknowns,
                   std::span<const SketchLine> lines, const FitLinesStart& start) {
  return LinesSearch(model, unknowns, {lines.begin(), lines.end()}, start).run();
}

}  // namespace bodyline::sketch
