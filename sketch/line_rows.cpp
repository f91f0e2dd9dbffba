#include "sketch/line_rows.hpp"

#include <algorithm>
#include <cmath>

#include "sketch/curve_rows.hpp"
#include "sketch/median.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;

constexpr double doubtful = 3.0;  // deviations
constexpr double end_on = 1e-3;   // speed in the picture, relative to the line's length

/// Adds rows of one line.
class LineRows {
 public:
  LineRows(const LineState& state, std::span<const Vector2d> picture, const CurveUnknowns& unknowns,
           int column)
      : state_(state),
        picture_(picture),
        axes_(model::view_axes(state.line->view)),
        rows_(unknowns, state.line->curve, {column, column + 1}) {}

  void across(std::size_t k, double weight) {
    const CurveJet<2> jet = curve_jet<2>(picture_, state_.feet[k]);
    const double speed = jet.first.norm();
    if (!(speed > end_on * state_.line->length)) return;
    const Vector2d square(-jet.first.y() / speed, jet.first.x() / speed);
    add(state_.feet[k], square, square.dot(jet.point - state_.line->points[k]), weight, 0.0, 0.0);
    if (has_foot(state_, k)) return;
    // A curve that runs off the end of its line, or on behind it, must not gain by that.
    const Vector2d tangent = jet.first / speed;
    add(state_.feet[k], tangent, tangent.dot(jet.point - state_.line->points[k]), weight, 0.0, 0.0);
  }

  void along(std::size_t k, double weight) {
    const double t = state_.offset + state_.step * state_.drawn[k];
    const CurveJet<2> jet = curve_jet<2>(picture_, t);
    const double speed = jet.first.norm();
    if (!(speed > end_on * state_.line->length)) return;
    const Vector2d tangent = jet.first / speed;
    add(t, tangent, tangent.dot(jet.point - state_.line->points[k]), weight, speed,
        speed * state_.drawn[k]);
  }

  // The end of the curve, 0 or 1, beside the end of the line.
  void end(std::size_t k, double t, double weight) {
    const CurveJet<2> jet = curve_jet<2>(picture_, t);
    const double speed = jet.first.norm();
    if (!(speed > end_on * state_.line->length)) return;
    const Vector2d tangent = jet.first / speed;
    add(t, tangent, tangent.dot(jet.point - state_.line->points[k]), weight, 0.0, 0.0);
  }

  void add_to(NormalEquations& equations) const { rows_.add_to(equations); }

 private:
  void add(double t, const Vector2d& direction, double off, double weight, double by_offset,
           double by_step) {
    rows_.add(model::bernstein(int(picture_.size()) - 1, t).d[0],
              direction.x() * axes_.right + direction.y() * axes_.up, off, weight,
              {by_offset, by_step});
  }

  const LineState& state_;
  std::span<const Vector2d> picture_;
  model::ViewAxes axes_;
  CurveRows rows_;
};

}  // namespace

LineWeights line_weights(const LineState& state, std::span<const Vector2d> picture, double noise,
                         double carelessness, bool settled) {
  const LineErrors errors = line_errors(state, picture);
  const double deviation = settled ? std::max(noise, normal_deviation * errors.tangent) : noise;
  LineWeights weights{std::vector<double>(state.feet.size(), 0.0), {}};
  weights.along = weights.across;
  weights.ends = 1.0 / std::max(noise, carelessness * state.line->length);
  // Points between those that were drawn share their errors.
  const double share =
      std::sqrt(std::min(1.0, double(state.line->told) / double(state.feet.size())));
  for (std::size_t k = 0; k < state.feet.size(); ++k) {
    if (!has_foot(state, k) && !is_held(state, k)) continue;
    weights.across[k] = share / noise;
    if (!state.follows) continue;
    weights.along[k] = share / deviation;
    if (settled)
      weights.along[k] /= std::hypot(1.0, error_along(state, picture, k) / (doubtful * deviation));
  }
  return weights;
}

void add_line_rows(const LineState& state, std::span<const Vector2d> picture,
                   const LineWeights& weights, const CurveUnknowns& unknowns, int column,
                   NormalEquations& equations) {
  LineRows rows(state, picture, unknowns, column);
  for (std::size_t k = 0; k < state.feet.size(); ++k) {
    if (weights.across[k] > 0.0) rows.across(k, weights.across[k]);
    if (weights.along[k] > 0.0) rows.along(k, weights.along[k]);
  }
  if (state.holds_first) rows.end(0, 0.0, weights.ends);
  if (state.holds_last) rows.end(state.feet.size() - 1, 1.0, weights.ends);
  rows.add_to(equations);
}

void add_drawn_rows(const LineState& state, std::span<const Vector2d> picture, double weight,
                    const CurveUnknowns& unknowns, NormalEquations& equations) {
  const model::ViewAxes axes = model::view_axes(state.line->view);
  CurveRows rows(unknowns, state.line->curve);
  for (std::size_t k = 0; k < state.drawn.size(); ++k) {
    const double t = state.offset + state.step * state.drawn[k];
    const Vector2d off = curve_jet<2>(picture, t).point - state.line->points[k];
    const auto basis = model::bernstein(int(picture.size()) - 1, t).d[0];
    rows.add(basis, axes.right, off.x(), weight);
    rows.add(basis, axes.up, off.y(), weight);
  }
  rows.add_to(equations);
}

}  // namespace bodyline::sketch
