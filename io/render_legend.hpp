#pragma once

#include <string>

#include "io/camera.hpp"
#include "io/picture.hpp"
#include "io/render_map.hpp"

namespace bodyline::io {

/// The part of a picture that is left for the body between title and legend.
Frame body_frame(int width, int height, const MapColors& colors, bool with_title);

/// Draws the title and the legend of a map. Text is left out where no font can be found.
void draw_legend(Picture& picture, const MapColors& colors, const std::string& title);

}  // namespace bodyline::io
