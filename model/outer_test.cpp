#include "model/outer_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bodyline::model {
namespace {

using Eigen::Vector2d;

// In cells of the mask: where a walk into the open begins and where it may end.
constexpr double begin = 1e-3;
constexpr double ends[] = {1.6, 2.5, 4.0};
constexpr double cells_per_bin = 4.0;
// From the normal, so that a point in a corner between two lines finds its way out.
constexpr double turns_deg[] = {0.0, 40.0, -40.0, 75.0, -75.0};

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool segments_cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const Vector2d along = b - a, other = d - c;
  return cross(along, c - a) * cross(along, d - a) <= 0.0 &&
         cross(other, a - c) * cross(other, b - c) <= 0.0 &&
         // On one line both products vanish; then the intervals tell.
         (std::max(a.x(), b.x()) >= std::min(c.x(), d.x())) &&
         (std::max(c.x(), d.x()) >= std::min(a.x(), b.x())) &&
         (std::max(a.y(), b.y()) >= std::min(c.y(), d.y())) &&
         (std::max(c.y(), d.y()) >= std::min(a.y(), b.y()));
}

}  // namespace

OuterTest::OuterTest(PictureMask mask, std::vector<std::vector<Vector2d>> lines)
    : mask_(std::move(mask)), bin_(cells_per_bin * mask_.cell()) {
  columns_ = int(mask_.width() / cells_per_bin) + 1;
  rows_ = int(mask_.height() / cells_per_bin) + 1;
  bins_.resize(std::size_t(columns_) * rows_);
  for (int line = 0; line < int(lines.size()); ++line) {
    for (int k = 0; k + 1 < int(lines[line].size()); ++k) {
      const Segment segment{lines[line][k], lines[line][k + 1], line, k};
      const Eigen::Array2i low = bin_of(segment.a.cwiseMin(segment.b));
      const Eigen::Array2i high = bin_of(segment.a.cwiseMax(segment.b));
      for (int row = low.y(); row <= high.y(); ++row) {
        for (int column = low.x(); column <= high.x(); ++column)
          bins_[std::size_t(row) * columns_ + column].push_back(int(segments_.size()));
      }
      segments_.push_back(segment);
    }
  }
}

Eigen::Array2i OuterTest::bin_of(const Vector2d& point) const {
  const Vector2d at = (point - mask_.origin()) / bin_;
  return {int(std::clamp(std::floor(at.x()), 0.0, columns_ - 1.0)),
          int(std::clamp(std::floor(at.y()), 0.0, rows_ - 1.0))};
}

bool OuterTest::crossed(const Vector2d& a, const Vector2d& b, const Place& place) const {
  const Eigen::Array2i low = bin_of(a.cwiseMin(b)), high = bin_of(a.cwiseMax(b));
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      for (const int k : bins_[std::size_t(row) * columns_ + column]) {
        const Segment& segment = segments_[k];
        // A chord of the curve that the point itself lies on may bulge over it.
        const bool own = segment.line == place.line && segment.index >= place.first - 1 &&
                         segment.index <= place.last;
        if (!own && segments_cross(a, b, segment.a, segment.b)) return true;
      }
    }
  }
  return false;
}

bool OuterTest::leads_out(const Vector2d& point, const Vector2d& direction,
                          const Place& place) const {
  const Vector2d from = point + begin * mask_.cell() * direction;
  for (const double end : ends) {
    const Vector2d to = point + end * mask_.cell() * direction;
    if (mask_.open(to)) return !crossed(from, to, place);
  }
  return false;
}

bool OuterTest::opens(const Vector2d& point, const Vector2d& side, const Place& place) const {
  const Vector2d along(-side.y(), side.x());
  for (const double turn : turns_deg) {
    const double angle = turn * std::numbers::pi / 180.0;
    if (leads_out(point, std::cos(angle) * side + std::sin(angle) * along, place)) return true;
  }
  return false;
}

bool OuterTest::clear(const Vector2d& point, const Vector2d& direction, double length,
                      const Place& place) const {
  return !crossed(point + begin * mask_.cell() * direction, point + length * direction, place);
}

std::optional<Vector2d> OuterTest::outwards(const Vector2d& point, const Vector2d& normal,
                                            const Place& place) const {
  if (opens(point, normal, place)) return normal;
  if (opens(point, -normal, place)) return -normal;
  return std::nullopt;
}

}  // namespace bodyline::model
