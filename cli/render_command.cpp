#include "cli/render_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/stage_option.hpp"
#include "io/picture.hpp"
#include "io/render.hpp"
#include "model/build.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model;
  Output output;
  std::string view = "iso", map = "shade", size = "1600x900", stage = "body", title;
  std::optional<double> range;
  int samples = io::RenderOptions{}.samples;
};

io::RenderOptions render_options(const Request& request) {
  io::RenderOptions options;
  options.view = io::view_from_name(request.view);
  options.map = io::map_from_name(request.map);
  const io::PictureSize size = io::size_from_text(request.size);
  options.width = size.width;
  options.height = size.height;
  options.samples = request.samples;
  options.curvature_range = request.range;
  options.title = request.title;
  return options;
}

void run(Context& context, const Request& request) {
  check_output(request.output, request.model, {".png"});
  io::RenderOptions options = render_options(request);
  const model::Stage stage = stage_from_name(request.stage);
  const model::Model model = load_model(context, request.model);
  {
    Progress progress(context, "rendering " + request.output.path);
    options.on_progress = [&progress](double fraction) { progress.update(fraction); };
    io::write_png(io::render(model::build(model, stage), options), request.output.path,
                  request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  }
  *context.out << fmt::format("{}: {}, {}, {} x {} pixels\n", request.output.path, request.map,
                              request.view, options.width, options.height);
}

void add_picture_options(CLI::App& command, Request& request) {
  command
      .add_option("--view", request.view,
                  fmt::format("{} or AZ,EL in degrees", fmt::join(io::view_names(), ", ")))
      ->capture_default_str();
  command
      .add_option("--map", request.map,
                  fmt::format("What colours say: {}", fmt::join(io::map_names(), ", ")))
      ->capture_default_str();
  command.add_option("--size", request.size, "Width and height in pixels")->capture_default_str();
  add_stage(command, request.stage);
  command.add_option("--range", request.range,
                     "Curvature at which the colours of a curvature map end, 1/m (mean) or 1/m^2 "
                     "(Gauss); found from the body when left out");
  command.add_option("--samples", request.samples, "Rays per pixel along edges, 1 to 64")
      ->capture_default_str();
  command.add_option("--title", request.title, "Text at the top left");
}

}  // namespace

void add_render_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "render", "Draw a picture of a model",
                  "bodyline render cars/model1.toml -o zebra.png --view side --map zebra");
  add_model(*command, request->model);
  add_output(*command, request->output, "Picture to write (.png)");
  add_picture_options(*command, *request);
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
