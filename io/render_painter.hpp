#pragma once

#include <Eigen/Core>
#include <vector>

#include "io/camera.hpp"
#include "io/render_map.hpp"
#include "io/render_occlusion.hpp"
#include "io/render_scene.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// What is seen through a point of the picture.
struct Seen {
  Color color;    ///< linear light
  int face = -1;  ///< -1 for the floor and the backdrop
};

/// The colour seen through any point of the picture. Refers to its arguments, which must outlive
/// it; queries may run in several threads.
class Painter {
 public:
  Painter(const std::vector<model::Surface>& faces, const RayScene& scene,
          const Occlusion& occlusion, const MapColors& colors, const Camera& camera,
          const std::vector<Eigen::Vector3d>& points, int picture_height);

  /// At picture position (x, y), pixels from the left and from the top.
  Seen look(double x, double y) const;

 private:
  Color face_color(const Ray& ray, const Hit& hit) const;
  Color floor_color(const Ray& ray, const Color& background) const;
  double edge_line(const model::SurfaceJet& jet, const Ray& ray, const Hit& hit) const;

  const std::vector<model::Surface>& faces_;
  const RayScene& scene_;
  const Occlusion& occlusion_;
  const MapColors& colors_;
  const Camera& camera_;
  double picture_height_;
  double size_ = 1.0;     // the body's diagonal, mm
  double nearest_ = 0.0;  // how far the body reaches towards the camera
  bool from_above_ = true;
};

}  // namespace bodyline::io
