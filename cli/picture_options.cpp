#include "cli/picture_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bodyline::cli {

void add_picture_options(CLI::App& command, PictureRequest& request) {
  command
      .add_option("--view", request.view,
                  fmt::format("{} or AZ,EL in degrees", fmt::join(io::view_names(), ", ")))
      ->capture_default_str();
  command.add_option("--size", request.size, "Width and height in pixels")->capture_default_str();
  command.add_option("--samples", request.samples, "Rays per pixel along edges, 1 to 64")
      ->capture_default_str();
  command.add_option("--title", request.title, "Text at the top left");
}

io::RenderOptions picture_options(const PictureRequest& request) {
  io::RenderOptions options;
  options.view = io::view_from_name(request.view);
  const io::PictureSize size = io::size_from_text(request.size);
  options.width = size.width;
  options.height = size.height;
  options.samples = request.samples;
  options.title = request.title;
  return options;
}

}  // namespace bodyline::cli
