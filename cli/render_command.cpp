#include "cli/render_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/picture_options.hpp"
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
  PictureRequest picture;
  std::string map = "shade", stage = "body";
  std::optional<double> range;
  bool left = false;
};

io::RenderOptions render_options(const Request& request) {
  io::RenderOptions options = picture_options(request.picture);
  options.map = io::map_from_name(request.map);
  options.curvature_range = request.range;
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
    const auto halves = request.left ? model::Halves::left_and_central : model::Halves::both;
    io::write_png(io::render(model::build(model, stage, halves), options), request.output.path,
                  request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  }
  *context.out << fmt::format("{}: {}, {}, {} x {} pixels\n", request.output.path, request.map,
                              request.picture.view, options.width, options.height);
}

void add_map_options(CLI::App& command, Request& request) {
  command
      .add_option("--map", request.map,
                  fmt::format("What colours say: {}", fmt::join(io::map_names(), ", ")))
      ->capture_default_str();
  add_stage(command, request.stage);
  command.add_option("--range", request.range,
                     "Curvature at which the colours of a curvature map end, 1/m (mean) or 1/m^2 "
                     "(Gauss); found from the body when left out");
  command.add_flag("--left", request.left, "Without the mirror images of the left half");
}

}  // namespace

void add_render_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "render", "Draw a picture of a model",
                  "bodyline render cars/model1.toml -o zebra.png --view side --map zebra");
  add_model(*command, request->model);
  add_output(*command, request->output, "Picture to write (.png)");
  add_picture_options(*command, request->picture);
  add_map_options(*command, *request);
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
