#include "model/silhouette_outline.hpp"

#include <algorithm>
#include <limits>

namespace bodyline::model {
namespace {

using Eigen::Vector2d;
using Line = std::vector<Vector2d>;

constexpr double same_line = 0.1;  // mm

double length_of(const Line& line) {
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  return length;
}

// Takes the line with the end nearest to a point, turned so that it begins there; none when that is
// farther than `gap`.
Line take_nearest(std::vector<Line>& lines, const Vector2d& point, double gap) {
  std::size_t nearest = lines.size();
  double least = gap;
  bool from_back = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (const bool back : {false, true}) {
      const double distance = ((back ? lines[k].back() : lines[k].front()) - point).norm();
      if (distance > least) continue;
      least = distance;
      nearest = k;
      from_back = back;
    }
  }
  if (nearest == lines.size()) return {};
  Line line = std::move(lines[nearest]);
  lines.erase(lines.begin() + std::ptrdiff_t(nearest));
  if (from_back) std::reverse(line.begin(), line.end());
  return line;
}

// Extends a line at its end as far as others go on, or until it meets its beginning.
void extend(Line& line, std::vector<Line>& lines, double gap) {
  while (true) {
    const double to_begin = (line.back() - line.front()).norm();
    const Line next =
        take_nearest(lines, line.back(), line.size() > 2 ? std::min(gap, to_begin) : gap);
    if (next.empty()) return;
    line.insert(line.end(), next.begin(), next.end());
  }
}

// Of a point from the first `count` points of a line.
double distance_to(const Line& line, std::size_t count, const Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < count; ++k) {
    const Vector2d along = line[k] - line[k - 1];
    const double squared = along.squaredNorm();
    const double t =
        squared > 0.0 ? std::clamp((point - line[k - 1]).dot(along) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, (line[k - 1] + t * along - point).norm());
  }
  return least;
}

// Lines without what lies upon longer ones, as the rims of both bumpers do in a view from the
// front, and without what runs back upon itself, as the picture of a flat arch does.
std::vector<Line> without_doubles(std::vector<Line> lines) {
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return length_of(a) > length_of(b); });
  std::vector<Line> kept;
  for (const Line& line : lines) {
    std::vector<Line> parts;
    bool inside = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const bool doubled = distance_to(line, k > 1 ? k - 1 : 0, line[k]) <= same_line ||
                           std::any_of(kept.begin(), kept.end(), [&](const Line& other) {
                             return distance_to(other, other.size(), line[k]) <= same_line;
                           });
      if (!doubled && !inside) parts.emplace_back();
      if (!doubled) parts.back().push_back(line[k]);
      inside = !doubled;
    }
    for (Line& part : parts) {
      if (part.size() > 1) kept.push_back(std::move(part));
    }
  }
  return kept;
}

}  // namespace

Vector2d mirrored_picture(View view, const Vector2d& picture) {
  switch (view) {
    case View::front:
    case View::rear:
      return {-picture.x(), picture.y()};
    case View::top:
      return {picture.x(), -picture.y()};
    case View::side:
      break;
  }
  return picture;
}

std::vector<Line> silhouette_outline(const std::vector<SilhouetteCurve>& pieces, View view,
                                     double gap) {
  std::vector<Line> open, outlines;
  for (const SilhouetteCurve& piece : pieces) {
    Line line, image;
    for (const SilhouettePoint& point : piece.points) {
      line.push_back(point.picture);
      image.push_back(mirrored_picture(view, point.picture));
    }
    if (piece.closed) {
      line.push_back(line.front());
      image.push_back(image.front());
    }
    std::vector<Line>& to = piece.closed ? outlines : open;
    to.push_back(std::move(line));
    if (view != View::side) to.push_back(std::move(image));
  }
  open = without_doubles(std::move(open));
  while (!open.empty()) {
    Line line = std::move(open.front());
    open.erase(open.begin());
    extend(line, open, gap);
    const bool closes = line.size() > 2 && (line.back() - line.front()).norm() <= gap;
    if (closes) {
      line.push_back(line.front());
    } else {
      std::reverse(line.begin(), line.end());
      extend(line, open, gap);
    }
    outlines.push_back(std::move(line));
  }
  return outlines;
}

}  // namespace bodyline::model
