#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bodyline::io {

/// Where the body is looked at from. Azimuth 0 looks at the front, 90 at the left side, 180 at the
/// rear, 270 at the right side; elevation 0 is level, 90 looks straight down. Degrees.
struct View {
  double azimuth = 38.0, elevation = 13.0;
  bool perspective = true;  ///< a long lens; otherwise parallel projection
};

/// The view named "iso", "front", "rear", "side" (the left side) or "top" (the front of the car at
/// the left of the picture), or "AZ,EL" in degrees, a perspective view. Throws
/// std::invalid_argument for anything else and for an elevation outside -90..90.
View view_from_name(const std::string& name);

/// The names that `view_from_name` knows.
std::vector<std::string> view_names();

struct Ray {
  Eigen::Vector3d origin, direction;  ///< direction has length 1
};

/// The part of the picture that the body fills, in pixels.
struct Frame {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// A camera whose picture shows a cloud of points as large as the frame allows, in its middle.
class Camera {
 public:
  /// Throws std::invalid_argument when there is no point.
  Camera(const View& view, const std::vector<Eigen::Vector3d>& points, const Frame& frame);

  /// The ray through picture position (x, y), pixels from the left and from the top.
  Ray ray(double x, double y) const;

  /// The picture position of a point.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const;

  /// Size of a pixel, mm, at a distance along the ray.
  double pixel_size(double distance) const;

  /// Unit vector from the body to the camera.
  const Eigen::Vector3d& towards() const { return towards_; }
  bool perspective() const { return perspective_; }

 private:
  Eigen::Vector2d plane_position(const Eigen::Vector3d& point) const;

  bool perspective_ = true;
  Eigen::Vector3d towards_, right_, up_, eye_;
  double scale_ = 1.0;                                         // pixels per unit of the image plane
  Eigen::Vector2d plane_centre_{0.0, 0.0}, centre_{0.0, 0.0};  // in the image plane, in pixels
};

}  // namespace bodyline::io
