#pragma once

#include <cstdint>
#include <vector>

#include "io/read_scan.hpp"
#include "model/random.hpp"

namespace bodyline::io {

/// Whether a point is one: finite, and not so far that its square overflows.
bool is_usable(const Eigen::Vector3d& point);

/// Takes the points of a file one by one and keeps a uniform random choice of bounded size
/// (J. Vitter, Random sampling with a reservoir, 1985, algorithm R).
class ScanCollector {
 public:
  explicit ScanCollector(const ReadScanOptions& options)
      : most_(options.most_points), random_(options.seed) {}

  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal = Eigen::Vector3d::Zero());

  /// The points kept, in the order they came. Normals are given unit length. Where more than half
  /// of the points have none (zero or not finite) all go without; otherwise those points are
  /// dropped.
  ScanFile finish(std::string format);

 private:
  struct Kept {
    Eigen::Vector3d point, normal;
    std::uint64_t index;
  };

  std::size_t most_;
  model::Random random_;
  std::vector<Kept> kept_;
  std::uint64_t points_ = 0, usable_ = 0;
};

}  // namespace bodyline::io
