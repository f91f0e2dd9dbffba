#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "strokes/foot_point.hpp"
#include "strokes/net.hpp"

namespace bodyline::strokes {

/// The nearest point of a surface.
struct FootPoint {
  int patch = -1;
  Eigen::Vector2d st{0.0, 0.0};
  Eigen::Vector2d place{0.0, 0.0};  ///< in the domain
  Eigen::Vector3d point{0.0, 0.0, 0.0};
  double distance = 0.0;
};

/// Finds the patches and edges of a net that are near a point: boxes in two R-trees, facets of
/// every patch. Knows the net as it was when last told of changes.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(const Net& net);
  ~SurfaceIndex();
  SurfaceIndex(SurfaceIndex&&) noexcept;
  SurfaceIndex& operator=(SurfaceIndex&&) noexcept;

  /// Takes patches and edges that are new or have changed.
  void update(const Net& net, const std::set<int>& patches, const std::set<int>& edges);

  /// The nearest point of the surface. None when the point is not finite, or its
  /// distance is too large for a double.
  std::optional<FootPoint> foot_point(const Net& net, const Eigen::Vector3d& point) const;

  /// Edges whose boxes, widened by `distance`, meet the box around the points; in order.
  std::vector<int> edges_near(const std::vector<Eigen::Vector3d>& points, double distance) const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace bodyline::strokes
