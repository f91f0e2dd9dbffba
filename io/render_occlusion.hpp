#pragma once

#include <Eigen/Core>
#include <vector>

#include "io/render_scene.hpp"
#include "io/tessellate.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// A table of numbers over a rectangle, linear in between; outside it has its border's values.
struct Table2 {
  int nx = 0, ny = 0;         ///< points per direction, at least 2
  std::vector<float> values;  ///< nx x ny, y fastest

  float& at(int ix, int iy) { return values[ix * ny + iy]; }
  float at(int ix, int iy) const { return values[ix * ny + iy]; }
  /// x and y from 0 to 1 across the rectangle.
  double sample(double x, double y) const;
};

/// How closely occlusion is looked at.
struct OcclusionDetail {
  int face_cells = 10;  ///< per direction, of a face's table
  int ground_cells_x = 144, ground_cells_y = 96;
  int face_directions = 64, ground_directions = 128;
};

/// How much of the sky each point of the body and of the ground under it sees: 1 in the open, 0
/// when enclosed. Found once on coarse grids; smooth in between. Does not depend on the number of
/// threads.
class Occlusion {
 public:
  Occlusion(const RayScene& scene, const std::vector<model::Surface>& faces,
            const std::vector<FaceGrid>& grids, const OcclusionDetail& detail = {});

  /// On the outside of a face.
  double face(int index, double u, double v) const { return faces_[index].sample(u, v); }

  /// On the ground, which touches the body's lowest point.
  double ground(double x, double y) const;

  double ground_height() const { return ground_height_; }

 private:
  void find_ground(const RayScene& scene, const std::vector<FaceGrid>& grids);
  double seen_from_face(const RayScene& scene, const Eigen::Vector3d& point,
                        const Eigen::Vector3d& normal) const;

  OcclusionDetail detail_;
  double ground_height_ = 0.0;
  double offset_ = 1.0;  // mm by which rays start off the body
  Eigen::Vector2d ground_low_{0.0, 0.0}, ground_size_{1.0, 1.0};
  Table2 ground_;
  std::vector<Table2> faces_;
  std::vector<Eigen::Vector3d> directions_;
};

}  // namespace bodyline::io
