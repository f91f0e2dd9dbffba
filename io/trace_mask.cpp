#include "io/trace_mask.hpp"

#include <potracelib.h>

#include <algorithm>
#include <climits>
#include <memory>
#include <new>
#include <stdexcept>

namespace bodyline::io {
namespace {

using Eigen::Vector2d;

constexpr int word_bits = int(sizeof(potrace_word)) * CHAR_BIT;

// potrace counts its rows from below and its pixels from the highest bit of a word.
std::vector<potrace_word> bitmap_words(const Mask& mask, int words_per_row) {
  std::vector<potrace_word> words(std::size_t(words_per_row) * mask.height, 0);
  for (int row = 0; row < mask.height; ++row) {
    potrace_word* const line = &words[std::size_t(mask.height - 1 - row) * words_per_row];
    for (int x = 0; x < mask.width; ++x) {
      if (mask.inside[std::size_t(row) * mask.width + x] == 0) continue;
      line[x / word_bits] |= potrace_word(1) << (word_bits - 1 - x % word_bits);
    }
  }
  return words;
}

model::DrawnPath drawn_path(const potrace_path_t& traced, double height) {
  const auto point = [height](const potrace_dpoint_t& p) { return Vector2d(p.x, p.y - height); };
  const potrace_curve_t& curve = traced.curve;
  model::DrawnPath path;
  path.name = traced.sign == '+' ? "outline" : "hole";
  path.closed = true;
  Vector2d at = point(curve.c[curve.n - 1][2]);
  for (int k = 0; k < curve.n; ++k) {
    const Vector2d first = point(curve.c[k][0]), second = point(curve.c[k][1]),
                   end = point(curve.c[k][2]);
    if (curve.tag[k] == POTRACE_CURVETO) {
      path.segments.push_back({{at, first, second, end}});
    } else {
      path.segments.push_back(model::line_segment(at, second));
      path.segments.push_back(model::line_segment(second, end));
    }
    at = end;
  }
  return path;
}

}  // namespace

std::vector<model::DrawnPath> trace_mask(const Mask& mask) {
  const int words_per_row = (mask.width + word_bits - 1) / word_bits;
  std::vector<potrace_word> words = bitmap_words(mask, words_per_row);
  const potrace_bitmap_t bitmap{mask.width, mask.height, words_per_row, words.data()};
  const std::unique_ptr<potrace_param_t, void (*)(potrace_param_t*)> parameters(
      potrace_param_default(), potrace_param_free);
  if (!parameters) throw std::bad_alloc();
  parameters->turdsize = std::max<int>(2, int(mask.inside.size() / 100000));
  const std::unique_ptr<potrace_state_t, void (*)(potrace_state_t*)> state(
      potrace_trace(parameters.get(), &bitmap), potrace_state_free);
  if (!state || state->status != POTRACE_STATUS_OK) throw std::bad_alloc();
  std::vector<std::pair<int, model::DrawnPath>> found;
  for (const potrace_path_t* path = state->plist; path != nullptr; path = path->next)
    found.emplace_back(path->area, drawn_path(*path, mask.height));
  if (found.empty()) throw std::invalid_argument("shows specks alone");
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<model::DrawnPath> paths;
  for (auto& [area, path] : found) paths.push_back(std::move(path));
  return paths;
}

}  // namespace bodyline::io
