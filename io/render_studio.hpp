#pragma once

#include <Eigen/Core>

#include "io/palette.hpp"
#include "io/render_occlusion.hpp"

/// The studio the car stands in: a light backdrop, a long light box overhead, strips of light at
/// both sides, in front and behind. Everything is mirror-symmetric in y.
namespace bodyline::io {

/// The backdrop at a height of the picture, 0 at its top and 1 at its bottom.
Color backdrop(double from_top);

/// Light that arrives from a direction (unit length), 1 = white paper. `blur` (0 to 1) softens the
/// edges of the lamps, for reflections in a rough surface.
Color studio_light(const Eigen::Vector3d& direction, double blur);

/// What is needed to shade a point of the outside.
struct ShadedPoint {
  Eigen::Vector3d position;   ///< mm
  Eigen::Vector3d normal;     ///< unit, towards the viewer's side of the face
  Eigen::Vector3d to_camera;  ///< unit
  double open = 1.0;          ///< how much of the sky it sees, 0 to 1
};

/// Light leaving car paint of a colour: soft diffuse light, a metallic sheen and a clear coat.
/// Tone-mapped to 0..1.
Color paint(const ShadedPoint& point, const Color& base, const Occlusion& occlusion);

/// Factor, about 0.75 to 1, that lets a coloured map keep a sense of form without changing its
/// hues.
float form_light(const ShadedPoint& point);

/// The dark inside of the body.
Color inside_color(const ShadedPoint& point);

/// Darkening of the floor by the body, 0..1.
float floor_light(double open);

}  // namespace bodyline::io
