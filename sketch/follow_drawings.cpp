#include "sketch/follow_drawings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "sketch/curve_jet.hpp"
#include "sketch/drawn_parameters.hpp"

namespace bodyline::sketch {
namespace {

constexpr double like_noise = 2.5;     // times the distance of the line from its curve
constexpr double least_misfit = 0.25;  // mm: taken for noise in any case
constexpr double even = 0.01;          // unevenness of a line along which nothing is told
constexpr double least_shown = 0.3;    // of the length of a curve that its line must show

// How large a line is, whatever the noise along it.
double extent_of(const SketchLine& line) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : line.points) box.extend(point);
  return box.diagonal().norm();
}

// Whether the lines of a curve show all three axes: then the speed of one that no two views show
// advancing along a common axis may still be told.
bool shows_space(int curve, const std::vector<LineState>& states) {
  Eigen::Vector3d shown(0.0, 0.0, 0.0);
  for (const LineState& state : states) {
    if (state.line->curve != curve) continue;
    const model::ViewAxes axes = model::view_axes(state.line->view);
    shown += axes.right.cwiseAbs() + axes.up.cwiseAbs();
  }
  return shown.minCoeff() > 0.0;
}

bool is_like_noise(double misfit, double distance) {
  return misfit <= like_noise * std::max(distance, least_misfit);
}

}  // namespace

void follow_drawings(const model::Model& model, std::vector<LineState>& states,
                     const std::vector<double>& distances) {
  std::vector<LineState*> uneven_lines, even_lines;
  std::size_t others = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    LineState& state = states[k];
    const SketchLine& line = *state.line;
    const model::Curve& curve = model.curves[line.curve];
    if (state.doubled || !shows_space(line.curve, states) ||
        extent_of(line) < least_shown * curve_length(curve.points))
      continue;
    DrawnParameters found = drawn_parameters(line, int(curve.points.size()) - 1);
    if (found.parameters.empty() || !is_like_noise(found.misfit, distances[k])) {
      ++others;
      continue;
    }
    state.drawn = std::move(found.parameters);
    (found.unevenness < even ? even_lines : uneven_lines).push_back(&state);
  }
  for (LineState* state : uneven_lines) state->follows = true;
  if (uneven_lines.size() < even_lines.size() + others) return;
  for (LineState* state : even_lines) state->follows = true;
}

bool leave_drawings(std::vector<LineState>& states, const std::vector<LineErrors>& errors) {
  std::map<int, std::size_t> worst;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (!states[k].follows || is_like_noise(errors[k].tangent, errors[k].normal)) continue;
    const auto [found, first] = worst.emplace(states[k].line->curve, k);
    if (errors[found->second].tangent < errors[k].tangent) found->second = k;
  }
  for (const auto& [curve, line] : worst) states[line].follows = false;
  return !worst.empty();
}

}  // namespace bodyline::sketch
