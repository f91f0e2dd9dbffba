#include "io/scan_collector.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::io {
namespace {

constexpr double farthest = 1e12;         // 1000 km in um
constexpr double shortest_normal = 1e-6;  // of what is meant to have length 1

// Zero where there is no normal.
Eigen::Vector3d unit_normal(const Eigen::Vector3d& normal) {
  if (!is_usable(normal)) return Eigen::Vector3d::Zero();
  const double length = normal.norm();
  if (length < shortest_normal) return Eigen::Vector3d::Zero();
  return normal / length;
}

}  // namespace

bool is_usable(const Eigen::Vector3d& point) {
  // A comparison with NaN is false.
  return std::abs(point.x()) <= farthest && std::abs(point.y()) <= farthest &&
         std::abs(point.z()) <= farthest;
}

void ScanCollector::add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  ++points_;
  if (!is_usable(point)) return;
  const std::uint64_t index = usable_++;
  if (kept_.size() < most_) {
    kept_.push_back({point, unit_normal(normal), index});
    return;
  }
  const std::uint64_t place = random_.below(usable_);
  if (place < most_) kept_[place] = {point, unit_normal(normal), index};
}

ScanFile ScanCollector::finish(std::string format) {
  std::sort(kept_.begin(), kept_.end(),
            [](const Kept& a, const Kept& b) { return a.index < b.index; });
  const auto has_normal = [](const Kept& kept) { return !kept.normal.isZero(0.0); };
  const auto normals =
      static_cast<std::size_t>(std::count_if(kept_.begin(), kept_.end(), has_normal));
  ScanFile file;
  file.format = std::move(format);
  file.points_in_file = points_;
  file.dropped = points_ - usable_;
  file.with_normals = normals > 0 && 2 * normals >= kept_.size();
  if (file.with_normals) file.dropped += kept_.size() - normals;
  for (const Kept& kept : kept_) {
    if (file.with_normals && !has_normal(kept)) continue;
    file.scan.points.push_back(kept.point);
    if (file.with_normals) file.scan.normals.push_back(kept.normal);
  }
  return file;
}

}  // namespace bodyline::io
