#include "cli/outline_command.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/load_model.hpp"
#include "cli/number_check.hpp"
#include "cli/output.hpp"
#include "cli/print_json.hpp"
#include "cli/stage_option.hpp"
#include "io/write_outline.hpp"
#include "model/silhouette.hpp"
#include "model/silhouette_outline.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

const std::string placeholder = "{view}";

struct Request {
  std::string model, stage = "body";
  std::vector<std::string> views;
  Output output;
  double spacing = 5.0;
  bool json = false;
};

std::vector<model::View> views_of(const Request& request) {
  if (request.views.empty()) return model::all_views();
  std::vector<model::View> views;
  for (const std::string& name : request.views) views.push_back(model::view_of(name));
  return views;
}

// The output with the view's name in place of "{view}".
Output output_of(const Request& request, model::View view) {
  Output output = request.output;
  const std::size_t at = output.path.find(placeholder);
  if (at != std::string::npos) output.path.replace(at, placeholder.size(), model::view_name(view));
  return output;
}

void check_outputs(const Request& request, const std::vector<model::View>& views) {
  if (views.size() > 1 && request.output.path.find(placeholder) == std::string::npos) {
    throw std::invalid_argument(
        "several views need a name with {view}, as -o 'car-{view}.svg', or one --view");
  }
  for (const model::View view : views)
    check_output(output_of(request, view), request.model, {".svg", ".csv"});
}

struct WrittenOutline {
  model::View view;
  std::string path;
  Eigen::Vector2d size;
  std::size_t points = 0, lines = 0;
};

WrittenOutline write(const model::SilhouetteBody& body, model::View view, const Request& request) {
  model::SilhouetteOptions options;
  options.spacing = request.spacing;
  const auto lines = model::silhouette_outline(model::silhouette(body, view, options), view);
  const Output output = output_of(request, view);
  io::write_outline(lines, model::view_name(view), output.path,
                    output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  WrittenOutline written{view, output.path, {0.0, 0.0}, 0, lines.size()};
  Eigen::AlignedBox2d box;
  for (const auto& line : lines) {
    written.points += line.size();
    for (const Eigen::Vector2d& point : line) box.extend(point);
  }
  if (!box.isEmpty()) written.size = box.sizes();
  return written;
}

void run(Context& context, const Request& request) {
  const std::vector<model::View> views = views_of(request);
  check_outputs(request, views);
  const model::Stage stage = stage_from_name(request.stage);
  const model::SilhouetteBody body =
      model::silhouette_body(load_model(context, request.model), stage);
  Json json = Json::object();
  std::string text;
  for (const model::View view : views) {
    const WrittenOutline written = write(body, view, request);
    json[model::view_name(view)] = {{"file", written.path},
                                    {"size_mm", {written.size.x(), written.size.y()}},
                                    {"lines", written.lines},
                                    {"points", written.points}};
    text += fmt::format("{}: {:.1f} x {:.1f} mm, {} points\n", written.path, written.size.x(),
                        written.size.y(), written.points);
  }
  if (request.json) {
    print_json(context, json);
  } else {
    *context.out << text;
  }
}

}  // namespace

void add_outline_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "outline", "Write the outlines of a model as views show them",
                  "bodyline outline cars/model1.toml -o 'model1-{view}.svg'");
  add_model(*command, request->model);
  add_output(*command, request->output,
             "Drawing to write (.svg, .csv); {view} stands for the view's name");
  command
      ->add_option("--view", request->views,
                   "side, top, front, rear, or several separated by commas; all when left out")
      ->type_name("VIEW")
      ->delimiter(',');
  add_stage(*command, request->stage);
  command->add_option("--spacing", request->spacing, "Distance of the points, about, mm")
      ->type_name("MM")
      ->check(number_between(0.1, 1000.0))
      ->capture_default_str();
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
