#include "cli/sketch_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/curve_values.hpp"
#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/sketch_text.hpp"
#include "cli/template_text.hpp"
#include "io/read_model.hpp"
#include "io/read_views.hpp"
#include "io/write_model.hpp"
#include "io/write_svg_drawing.hpp"
#include "model/suggest.hpp"
#include "sketch/curve_degrees.hpp"
#include "sketch/drawn_degrees.hpp"
#include "sketch/template_drawing.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string views, start, template_model;
  Output output;
  std::vector<std::string> tolerances, degrees;  // see curve_values
  bool json = false;
};

io::Overwrite overwriting(const Request& request) {
  return request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never;
}

void write_template(Context& context, const Request& request) {
  check_output(request.output, request.template_model, {".svg"});
  const sketch::TemplateDrawing drawn =
      sketch::template_drawing(load_model(context, request.template_model));
  io::SvgDrawingOptions options;
  options.locked = drawn.guides;
  for (const sketch::ViewTitle& title : drawn.titles)
    options.texts.push_back({title.text, title.layer, title.at, 120.0});
  options.style = [](const model::DrawnPath& path) {
    if (path.name == model::axes_name) return io::SvgStyle{"#c04040", 4.0};
    return path.name.empty() ? io::SvgStyle{"#d0d0d0", 3.0} : io::SvgStyle{"#1f4e8c", 6.0};
  };
  io::write_svg_drawing(drawn.drawing, request.output.path, options, overwriting(request));
  if (request.json) {
    print_json(context, {{"paths", drawn.drawing.paths.size()}});
  } else {
    *context.out << "drawing: " << request.output.path << "\n";
  }
}

model::Model start_of(Context& context, const Request& request, const io::ViewsFile& file) {
  if (!request.start.empty()) return load_model(context, request.start);
  if (!file.start.empty()) return load_model(context, file.start);
  return io::read_model_text(template_text(), "the template");
}

std::vector<std::string> curve_names(const model::Model& model) {
  std::vector<std::string> names;
  for (const model::Curve& curve : model.curves) names.push_back(curve.name);
  return names;
}

Eigen::AlignedBox3d box_of(const model::Model& model) {
  Eigen::AlignedBox3d box;
  for (const model::Curve& curve : model.curves)
    for (const Eigen::Vector3d& point : curve.points) box.extend(point);
  return box;
}

// What the command line says counts before what the file says.
sketch::CurveDegrees curve_degrees(const Request& request, const io::ViewsFile& file) {
  const CurveValues given = curve_values(request.degrees, "--degree", {2, 9, true});
  sketch::CurveDegrees degrees{file.degree, {}};
  for (const auto& [name, curve] : file.curves)
    if (curve.degree) degrees.by_name[name] = *curve.degree;
  if (given.all) degrees = {int(*given.all), {}};
  for (const auto& [name, degree] : given.by_name) degrees.by_name[name] = int(degree);
  return degrees;
}

sketch::SketchOptions sketch_options(const Request& request, const io::ViewsFile& file,
                                     const model::Model& start) {
  const CurveValues given = curve_values(request.tolerances, "--tolerance", {0.001, 1e6, false});
  sketch::SketchOptions options;
  if (file.tolerance) options.tolerance = *file.tolerance;
  for (const auto& [name, curve] : file.curves)
    if (curve.tolerance) options.tolerances[name] = *curve.tolerance;
  if (given.all) options.tolerance = *given.all, options.tolerances.clear();
  for (const auto& [name, tolerance] : given.by_name) options.tolerances[name] = tolerance;
  const std::vector<std::string> names = curve_names(start);
  for (const auto& [name, tolerance] : options.tolerances)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::invalid_argument(fmt::format("no curve is named '{}'; the nearest name is '{}'",
                                              name, model::nearest_name(name, names)));
  return options;
}

void warn(Context& context, const std::string& sentence) {
  if (!context.quiet) *context.err << "bodyline: warning: " << sentence << "\n";
}

void warn_of_names(Context& context, const sketch::SketchResult& result) {
  const std::vector<std::string> names = curve_names(result.model);
  for (const std::string& unknown : result.unknown)
    warn(context,
         fmt::format("the path '{}' is left out: no curve has its name; the nearest is '{}'",
                     unknown, model::nearest_name(unknown, names)));
}

void build_model(Context& context, const Request& request) {
  check_output(request.output, request.views, {".toml"});
  const io::ViewsFile file = io::read_views(request.views);
  const model::Model found = start_of(context, request, file);
  sketch::CurveDegrees degrees = curve_degrees(request, file);
  model::Model start = sketch::with_degrees(found, degrees);
  const sketch::SketchOptions options = sketch_options(request, file, start);
  io::PlacedViews placed =
      io::place_drawings(file.views, {file.length, file.width, file.height, box_of(start)});
  degrees =
      sketch::with_drawn_degrees(found, degrees, sketch::take_degrees(found, placed.drawings));
  start = sketch::with_degrees(found, degrees);
  for (const std::string& note : placed.notes) warn(context, note);
  sketch::SketchResult result;
  {
    const Progress progress(context, "building a body from " + request.views);
    result = sketch::sketch_model(start, placed.drawings, options);
  }
  result.model.name = std::filesystem::path(request.output.path).stem().string();
  io::write_model(result.model, request.output.path, overwriting(request));
  warn_of_names(context, result);
  if (request.json) {
    print_json(context, sketch_json(result));
  } else {
    *context.out << sketch_text(result) << "\nmodel: " << request.output.path << "\n";
  }
  if (has_contradictions(result)) context.exit_code = exit_findings;
}

void run(Context& context, const Request& request) {
  if (request.views.empty() == request.template_model.empty())
    throw std::invalid_argument(
        "give either drawings to build a body from, or --template MODEL to write a drawing");
  if (request.views.empty())
    write_template(context, request);
  else
    build_model(context, request);
}

}  // namespace

void add_sketch_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "sketch", "Build a body from drawings of its curves in several views",
                  "bodyline sketch --template cars/model1.toml -o views.svg\n"
                  "  bodyline sketch views.svg -o car.toml");
  command->add_option("VIEWS", request->views, "Drawings (.svg with layers, or .toml)")
      ->type_name("");
  command
      ->add_option("--template", request->template_model,
                   "Write a drawing of this model instead, to draw on")
      ->type_name("MODEL");
  command
      ->add_option("--start", request->start,
                   "Model with the curves' names and degrees; the template when left out")
      ->type_name("MODEL");
  add_output(*command, request->output, "Model to write, .toml; with --template the drawing, .svg");
  command
      ->add_option("--tolerance", request->tolerances,
                   "Distance of a line from its curve that is a contradiction; 10 when left out")
      ->type_name("[CURVE=]MM")
      ->take_all()
      ->expected(1);
  command
      ->add_option("--degree", request->degrees,
                   "Degree of all curves, or of one, 2 to 9; the start model's when left out")
      ->type_name("[CURVE=]N")
      ->take_all()
      ->expected(1);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
