#include "io/view_scales.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/place_drawings.hpp"

namespace bodyline::io {
namespace {

using model::View;

constexpr std::array<const char*, 3> size_names{"length", "width", "height"};

// A car at full size; what is drawn smaller on paper is far below.
constexpr std::array<std::array<double, 2>, 3> possible_sizes{
    {{2000.0, 9000.0}, {1000.0, 3500.0}, {800.0, 4000.0}}};

constexpr double worth_saying = 0.005;

void check_sizes(const std::vector<DrawnSize>& views, const KnownSizes& known) {
  for (int k = 0; k < 3; ++k) {
    if (known[k] && (!(*known[k] > 0.0) || !std::isfinite(*known[k])))
      throw std::invalid_argument(fmt::format("the {} is a number above 0, in mm", size_names[k]));
  }
  for (const DrawnSize& view : views) {
    if (!(view.size.minCoeff() > 1e-6 * view.size.maxCoeff()))
      throw std::invalid_argument(
          fmt::format("the drawing of the view {} is flat: it has no width or no height",
                      view_name(view.view)));
    if (view.scale && !(*view.scale > 0.0 && std::isfinite(*view.scale)))
      throw std::invalid_argument(
          fmt::format("the scale of the view {} is a number above 0", view_name(view.view)));
  }
}

// Which views and sizes have a scale, directly or through a size that they share with one.
struct Reach {
  std::vector<bool> views;
  std::array<bool, 3> sizes{};
};

Reach reach_of(const std::vector<DrawnSize>& views, const KnownSizes& known) {
  Reach reach;
  for (const DrawnSize& view : views) reach.views.push_back(view.scale.has_value());
  for (int k = 0; k < 3; ++k) reach.sizes[k] = known[k].has_value();
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t v = 0; v < views.size(); ++v) {
      const auto [right, up] = shown_sizes(views[v].view);
      const bool any = reach.views[v] || reach.sizes[right] || reach.sizes[up];
      const bool all = reach.views[v] && reach.sizes[right] && reach.sizes[up];
      if (!any || all) continue;
      reach.views[v] = reach.sizes[right] = reach.sizes[up] = grown = true;
    }
  }
  return reach;
}

bool possible_at_full_size(const DrawnSize& view) {
  const std::array<int, 2> shown = shown_sizes(view.view);
  for (int axis = 0; axis < 2; ++axis) {
    const auto [least, most] = possible_sizes[shown[axis]];
    const double size = view.unit_mm * view.size[axis];
    if (!(size >= least && size <= most)) return false;
  }
  return true;
}

// Gives views their scale on paper until all have one, or refuses the first that has none.
void take_full_size(std::vector<DrawnSize>& views, const KnownSizes& known,
                    std::vector<std::string>& notes) {
  while (true) {
    const std::vector<bool> reached = reach_of(views, known).views;
    std::size_t open = views.size(), drawn = views.size();
    for (std::size_t v = views.size(); v-- > 0;) {
      if (reached[v]) continue;
      open = v;
      if (possible_at_full_size(views[v])) drawn = v;
    }
    if (open == views.size()) return;
    if (drawn == views.size()) {
      const std::array<int, 2> shown = shown_sizes(views[open].view);
      throw NoScale(
          views[open].view,
          fmt::format(
              "nothing says how large the car is in the view {}: give a scale, or its {} or {}",
              view_name(views[open].view), size_names[shown[0]], size_names[shown[1]]));
    }
    views[drawn].scale = views[drawn].unit_mm;
    notes.push_back(fmt::format("The view {} is taken to be drawn at full size.",
                                view_name(views[drawn].view)));
  }
}

// Least squares of log(scale) + log(drawn) = log(size) over all that is not given.
void solve(const std::vector<DrawnSize>& views, const KnownSizes& known, ViewScales& result) {
  const Eigen::Index count = Eigen::Index(views.size());
  const auto known_scale = [&](Eigen::Index v) { return views[std::size_t(v)].scale; };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * count, count + 3);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count);
  for (Eigen::Index v = 0; v < count; ++v) {
    const DrawnSize& view = views[std::size_t(v)];
    const std::array<int, 2> shown = shown_sizes(view.view);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Index row = 2 * v + axis;
      const auto& size = known[std::size_t(shown[axis])];
      right[row] = -std::log(view.size[axis]);
      if (known_scale(v))
        right[row] -= std::log(*known_scale(v));
      else
        matrix(row, v) = 1.0;
      if (size)
        right[row] += std::log(*size);
      else
        matrix(row, count + shown[axis]) = -1.0;
    }
  }
  // Columns of what is given, or in no view, are zero: their least-norm solution is 0.
  const Eigen::VectorXd logs = matrix.completeOrthogonalDecomposition().solve(right);
  for (Eigen::Index v = 0; v < count; ++v)
    result.scales.push_back(known_scale(v).value_or(std::exp(logs[v])));
  for (int k = 0; k < 3; ++k) {
    const bool shown = matrix.col(count + k).any();
    result.size[k] = known[k] ? *known[k] : shown ? std::exp(logs[count + k]) : 0.0;
  }
}

// One size as each view has it: says or refuses what differs.
void compare(int size, const std::vector<DrawnSize>& views, const KnownSizes& known,
             ViewScales& result, std::vector<std::string>& refused) {
  std::vector<double> values;
  std::vector<std::string> words;
  bool chosen = false;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const std::array<int, 2> shown = shown_sizes(views[v].view);
    for (int axis = 0; axis < 2; ++axis) {
      if (shown[axis] != size) continue;
      values.push_back(result.scales[v] * views[v].size[axis]);
      words.push_back(fmt::format("{:.0f} mm in {}", values.back(), view_name(views[v].view)));
      chosen = chosen || !views[v].scale;
    }
  }
  if (known[size] && !values.empty()) {
    values.push_back(*known[size]);
    words.push_back(fmt::format("{:.0f} mm given", values.back()));
  }
  if (values.size() < 2) return;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double apart = *most / *least - 1.0;
  if (apart <= worth_saying) return;
  const std::string sentence = fmt::format("the drawings differ in their {} by {:.1f} %: {}",
                                           size_names[size], 100.0 * apart, fmt::join(words, ", "));
  if (apart > size_tolerance && chosen) return refused.push_back(sentence);
  result.notes.push_back("T" + sentence.substr(1) + ".");
}

}  // namespace

std::array<int, 2> shown_sizes(View view) {
  if (view == View::side) return {0, 2};
  if (view == View::top) return {0, 1};
  return {1, 2};
}

ViewScales view_scales(std::vector<DrawnSize> views, const KnownSizes& known) {
  check_sizes(views, known);
  ViewScales result;
  take_full_size(views, known, result.notes);
  solve(views, known, result);
  std::vector<std::string> refused;
  for (int size = 0; size < 3; ++size) compare(size, views, known, result, refused);
  if (!refused.empty()) throw std::invalid_argument(fmt::format("{}", fmt::join(refused, "; ")));
  return result;
}

}  // namespace bodyline::io
