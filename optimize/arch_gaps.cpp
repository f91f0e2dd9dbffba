#include "optimize/arch_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/bernstein.hpp"
#include "model/measures_wheelbase.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;
constexpr int samples_per_curve = 64;
constexpr double reach = 80.0;     // mm on both sides of the rim
constexpr double farthest = 40.0;  // that a rim may stand out beyond the scan's, mm
constexpr double beside = 40.0;    // a fender's points lie so near the rim across the car, mm
constexpr double sideways = 0.6;   // least y of the normals of a fender beside its arch
constexpr double least_band = 4.0, widest_band = 12.0;  // mm
constexpr double points_per_band = 6.0;
constexpr double hardly_any = 0.25;  // of the usual points of a band
// Parts by the angle about the wheel, from the rear over the top to the front.
struct Part {
  const char* name;
  double from, to;  // degrees
};
constexpr std::array<Part, 3> parts{{{"rear", 15, 60}, {"top", 60, 120}, {"front", 120, 165}}};

/// A point of a rim as the wheel sees it.
struct RimSample {
  double angle, radius, y;
};

RimSample seen_from(const model::ArchCircle& circle, const Vector3d& point) {
  const double x = point.x() - circle.x, z = point.z() - circle.z;
  return {std::atan2(z, x) / degree, std::hypot(x, z), point.y()};
}

std::vector<RimSample> rim_samples(const model::Model& model, const model::WheelArch& arch,
                                   const model::ArchCircle& circle) {
  std::vector<RimSample> samples;
  for (const int number : arch.curves) {
    const std::vector<Vector3d>& points = model.curves[std::size_t(number)].points;
    for (int k = 0; k <= samples_per_curve; ++k) {
      const auto basis =
          model::bernstein(int(points.size()) - 1, double(k) / samples_per_curve).d[0];
      Vector3d at = Vector3d::Zero();
      for (std::size_t i = 0; i < points.size(); ++i) at += basis[i] * points[i];
      samples.push_back(seen_from(circle, at));
    }
  }
  std::sort(samples.begin(), samples.end(),
            [](const RimSample& a, const RimSample& b) { return a.angle < b.angle; });
  return samples;
}

// The heights over the rim of the scan's points beside it, for each part.
std::array<std::vector<double>, parts.size()> heights_over(const std::vector<RimSample>& rim,
                                                           const model::ArchCircle& circle,
                                                           const Deviation& deviation) {
  std::array<std::vector<double>, parts.size()> heights;
  for (std::size_t k = 0; k < deviation.scan.points.size(); ++k) {
    if (std::abs(deviation.scan.normals[k].y()) < sideways) continue;
    const RimSample point = seen_from(circle, deviation.scan.points[k]);
    const auto at = std::lower_bound(
        rim.begin(), rim.end(), point.angle,
        [](const RimSample& sample, double angle) { return sample.angle < angle; });
    if (at == rim.begin() || at == rim.end()) continue;
    const double height = point.radius - at->radius;
    if (std::abs(height) > reach || std::abs(point.y - at->y) > beside) continue;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (point.angle >= parts[p].from && point.angle < parts[p].to) heights[p].push_back(height);
    }
  }
  return heights;
}

// Where points end from above, or nan.
double lower_edge(std::vector<double> heights) {
  std::sort(heights.begin(), heights.end());
  const auto from = [&](double height) {
    return std::lower_bound(heights.begin(), heights.end(), height);
  };
  const double per_mm = double(heights.end() - from(farthest)) / (reach - farthest);
  const double band = std::max(least_band, points_per_band / per_mm);
  if (!(band <= widest_band)) return std::nan("");
  const auto empty = [&](double top) {
    return double(from(top) - from(top - band)) < hardly_any * band * per_mm;
  };
  for (double top = farthest; top > -reach + 2.0 * band; top -= 0.5 * band) {
    if (empty(top) && empty(top - band) && from(top) != heights.end()) return *from(top);
  }
  return std::nan("");
}

}  // namespace

std::vector<ArchGap> arch_gaps(const model::Model& model, const Deviation& deviation) {
  std::vector<ArchGap> gaps;
  if (deviation.scan.normals.empty()) return gaps;
  for (const bool front : {true, false}) {
    const model::WheelArch& arch = front ? model.front_arch : model.rear_arch;
    const auto circle = model::arch_circle(model, arch);
    if (!circle) continue;
    const auto heights = heights_over(rim_samples(model, arch, *circle), *circle, deviation);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double edge = lower_edge(heights[p]);
      if (!std::isnan(edge)) gaps.push_back({front, parts[p].name, -edge});
    }
  }
  return gaps;
}

}  // namespace bodyline::optimize
