#include "sketch/sketch_line.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::sketch {
namespace {

using model::CubicSegment;

constexpr int least_points = 120, most_points = 3000;

double length_of(const CubicSegment& segment) {
  constexpr int pieces = 16;
  double length = 0.0;
  for (int k = 0; k < pieces; ++k)
    length += (segment.at(double(k + 1) / pieces) - segment.at(double(k) / pieces)).norm();
  return length;
}

// Where each segment begins and the last ends when all take equal steps.
std::vector<double> equal_knots(std::size_t count) {
  std::vector<double> knots(count + 1);
  for (std::size_t k = 0; k <= count; ++k) knots[k] = double(k) / double(count);
  return knots;
}

// The same with a continuous speed; empty where segments do not join smoothly.
std::vector<double> smooth_knots(const std::vector<CubicSegment>& segments) {
  constexpr double parallel = 0.985;  // cosine of 10 degrees
  std::vector<double> knots{0.0};
  double step = 1.0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    knots.push_back(knots.back() + step);
    if (k + 1 == segments.size()) break;
    const Eigen::Vector2d out = segments[k].derivative(1.0), in = segments[k + 1].derivative(0.0);
    if (!(out.dot(in) > parallel * out.norm() * in.norm())) return {};
    step *= in.norm() / out.norm();
  }
  if (!std::isfinite(knots.back())) return {};
  for (double& knot : knots) knot /= knots.back();
  return knots;
}

bool is_polyline(const std::vector<CubicSegment>& segments) {
  return std::all_of(segments.begin(), segments.end(), [](const CubicSegment& segment) {
    return model::line_segment(segment.points[0], segment.points[3]).points == segment.points;
  });
}

}  // namespace

void SketchLine::reverse() {
  std::reverse(points.begin(), points.end());
  for (std::vector<double>& parameters : drawn) {
    std::reverse(parameters.begin(), parameters.end());
    for (double& parameter : parameters) parameter = 1.0 - parameter;
  }
}

SketchLine sketch_line(const Stroke& stroke) {
  const std::vector<CubicSegment>& segments = stroke.path.segments;
  const int points_of_segment = is_polyline(segments) ? 1 : 3;
  SketchLine line{
      stroke.curve, stroke.view, {}, 0.0, points_of_segment * int(segments.size()) + 1, {}};
  std::vector<double> lengths;
  for (const CubicSegment& segment : segments) lengths.push_back(length_of(segment));
  for (const double length : lengths) line.length += length;
  std::vector<std::vector<double>> knots{equal_knots(segments.size())};
  if (segments.size() > 1 && !is_polyline(segments)) {
    knots.push_back(smooth_knots(segments));
    if (knots.back().empty()) knots.pop_back();
  }
  line.drawn.resize(knots.size());
  const std::size_t thinning = segments.size() / most_points + 1;
  const auto add = [&](std::size_t k, double t) {
    line.points.push_back(segments[k].at(t));
    for (std::size_t c = 0; c < knots.size(); ++c)
      line.drawn[c].push_back(knots[c][k] + t * (knots[c][k + 1] - knots[c][k]));
  };
  add(0, 0.0);
  for (std::size_t k = 0; k < segments.size(); k += thinning) {
    const int count = std::max(1, int(std::ceil(least_points * lengths[k] / line.length)));
    for (int i = 1; i <= count; ++i) add(k, double(i) / count);
  }
  return line;
}

}  // namespace bodyline::sketch
