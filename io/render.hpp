#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/camera.hpp"
#include "io/picture.hpp"
#include "io/render_map.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// Width and height in pixels.
struct PictureSize {
  int width = 1600, height = 900;
};

/// Reads "1600x900". Throws std::invalid_argument for anything else and for sizes `render` refuses.
PictureSize size_from_text(const std::string& text);

struct RenderOptions {
  View view;
  Map map = Map::shade;
  int width = 1600, height = 900;  ///< pixels, each from 64 to 8192
  int samples = 9;  ///< rays per pixel where neighbouring pixels differ, 1 to 64, rounded up to a
                    ///< square; 1 elsewhere
  /// Curvature at which the colours of a curvature map end on both sides, 1/m (mean) or 1/m^2
  /// (Gauss); absent: curvature_range() of the faces.
  std::optional<double> curvature_range;
  bool quick = false;  ///< coarser faces and shadows: for pictures of some hundred pixels
  const SurfaceField* field = nullptr;  ///< what Map::field shows; must outlive the drawing
  std::string title;                    ///< top left; none when empty
  std::function<void(double)>
      on_progress;  ///< fraction done, called by one thread at a time; may be empty
};

/// A ray-traced picture of faces on a light ground. Normals and curvatures are those of the exact
/// surfaces. The outside carries the map, the inside is dark. The same input gives the same
/// picture, bit by bit, for any number of threads. Throws std::invalid_argument when there is no
/// face, a point is not finite or an option is out of range.
Picture render(const std::vector<model::Surface>& faces, const RenderOptions& options);

}  // namespace bodyline::io
