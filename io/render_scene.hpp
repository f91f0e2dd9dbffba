#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "io/camera.hpp"
#include "io/tessellate.hpp"

namespace bodyline::io {

/// Where a ray meets a face.
struct Hit {
  int face = -1;
  double u = 0.0, v = 0.0;
  double distance = 0.0;
  bool along_normal =
      false;  ///< the ray travels in the direction of S_u x S_v, that is, meets the face's back
};

/// The tessellated body, ready for ray tracing. Queries may run in several threads at once, and
/// their answers do not depend on how many threads there are.
class RayScene {
 public:
  /// Throws std::runtime_error when the ray tracer cannot start.
  explicit RayScene(const std::vector<FaceGrid>& grids);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// The first face along the ray beyond `nearest` (mm).
  std::optional<Hit> first_hit(const Ray& ray, double nearest = 0.0) const;

  /// Whether the ray meets anything beyond `nearest`.
  bool blocked(const Ray& ray, double nearest = 0.0) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace bodyline::io
