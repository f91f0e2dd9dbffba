#pragma once

#include <string>

#include "cli/command.hpp"
#include "io/render.hpp"

namespace bodyline::cli {

/// How a picture is taken, as given on the command line.
struct PictureRequest {
  std::string view = "iso", size = "1600x900", title;
  int samples = io::RenderOptions{}.samples;
};

/// Adds --view, --size, --samples and --title.
void add_picture_options(CLI::App& command, PictureRequest& request);

/// Throws std::invalid_argument for an unknown view and a bad size.
io::RenderOptions picture_options(const PictureRequest& request);

}  // namespace bodyline::cli
