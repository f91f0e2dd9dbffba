#include "optimize/outline_samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/outer_test.hpp"
#include "model/silhouette_outline.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;
using model::View;

constexpr int mask_cells = 1500;      // along the longer side of a drawing
constexpr double finer = 0.25;        // of the spacing, while lengths are measured
constexpr double widest_slot = 50.0;  // mm, of those that a body does not follow
constexpr double same_point = 1e-6;

struct Line {
  std::vector<Vector2d> points;
  bool closed = false;
};

// A path at even distances, both ends of an open one among them.
Line even_line(const model::DrawnPath& path, double spacing) {
  const std::vector<Vector2d> fine = model::sample_path(path, finer * spacing);
  double length = 0.0;
  for (std::size_t k = 1; k < fine.size(); ++k) length += (fine[k] - fine[k - 1]).norm();
  Line line;
  line.closed = path.closed || (fine.back() - fine.front()).norm() <= same_point;
  const int steps = std::max(line.closed ? 3 : 1, int(std::lround(length / spacing)));
  const double step = length / steps;
  double walked = 0.0;
  line.points.push_back(fine.front());
  for (std::size_t k = 1; k < fine.size() && step > 0.0; ++k) {
    const Vector2d along = fine[k] - fine[k - 1];
    const double piece = along.norm();
    while (int(line.points.size()) < steps && walked + piece >= step * double(line.points.size())) {
      const double t = (step * double(line.points.size()) - walked) / piece;
      line.points.push_back(fine[k - 1] + t * along);
    }
    walked += piece;
  }
  if (!line.closed) line.points.push_back(fine.back());
  return line;
}

Vector2d normal_at(const Line& line, int k) {
  const int count = int(line.points.size());
  const int before = line.closed ? (k + count - 1) % count : std::max(k - 1, 0);
  const int after = line.closed ? (k + 1) % count : std::min(k + 1, count - 1);
  const Vector2d along = line.points[after] - line.points[before];
  return Vector2d(along.y(), -along.x()).normalized();
}

std::vector<Line> lines_of(const model::PlacedDrawing& drawing, double spacing) {
  std::vector<Line> lines;
  for (const model::DrawnPath& path : drawing.paths) {
    if (path.segments.empty()) continue;
    Line line = even_line(path, spacing);
    if (drawing.view == View::rear) {
      for (Vector2d& point : line.points) point.x() = -point.x();
    }
    if (line.points.size() > 1) lines.push_back(std::move(line));
  }
  if (lines.empty())
    throw std::invalid_argument("nothing is drawn in the view from the " +
                                model::view_name(drawing.view));
  return lines;
}

model::OuterTest outer_test(const std::vector<Line>& lines) {
  Eigen::AlignedBox2d box;
  std::vector<std::vector<Vector2d>> closed;
  for (const Line& line : lines) {
    closed.push_back(line.points);
    if (line.closed) closed.back().push_back(line.points.front());
    for (const Vector2d& point : line.points) box.extend(point);
  }
  model::PictureMask mask(box, mask_cells);
  for (const std::vector<Vector2d>& line : closed) {
    for (std::size_t k = 1; k < line.size(); ++k) mask.cover_line(line[k - 1], line[k]);
  }
  mask.flood();
  return model::OuterTest(std::move(mask), std::move(closed));
}

bool in_left_half(View view, const Vector2d& picture) {
  return view == View::side || (view == View::top ? picture.y() <= 0.0 : picture.x() >= 0.0);
}

void add_line(const Line& line, int index, const model::OuterTest& test, OutlineSamples& samples) {
  const int count = int(line.points.size());
  std::vector<int> place(count, -1);
  for (int k = 0; k < count; ++k) {
    const Vector2d& point = line.points[k];
    const Vector2d normal = normal_at(line, k);
    const model::OuterTest::Place at{index, k, k};
    const auto open = [&](const Vector2d& side) {
      return test.opens(point, side, at) && test.clear(point, side, widest_slot, at);
    };
    const bool right = open(normal), left = open(-normal);
    if (!right && !left) continue;
    const bool mirror = !in_left_half(samples.view, point);
    const Vector2d out = right ? normal : Vector2d(-normal);
    place[k] = int(samples.points.size());
    samples.points.push_back(mirror ? mirrored_picture(samples.view, point) : point);
    samples.normals.push_back(mirror ? mirrored_picture(samples.view, out) : out);
    samples.two_sided.push_back(right && left);
    samples.neighbours.push_back({-1, -1});
  }
  for (int k = 0; k < (line.closed ? count : count - 1); ++k) {
    const int from = place[k], to = place[(k + 1) % count];
    if (from < 0 || to < 0) continue;
    // A step across the plane of symmetry is none in the half picture.
    if (in_left_half(samples.view, line.points[k]) !=
        in_left_half(samples.view, line.points[(k + 1) % count]))
      continue;
    samples.neighbours[from][1] = to;
    samples.neighbours[to][0] = from;
  }
}

}  // namespace

OutlineSamples outline_samples(const model::PlacedDrawing& drawing, double spacing) {
  const std::vector<Line> lines = lines_of(drawing, spacing);
  const model::OuterTest test = outer_test(lines);
  OutlineSamples samples;
  samples.view = drawing.view == View::rear ? View::front : drawing.view;
  samples.drawn_view = drawing.view;
  samples.spacing = spacing;
  for (int index = 0; index < int(lines.size()); ++index)
    add_line(lines[index], index, test, samples);
  return samples;
}

}  // namespace bodyline::optimize
