#include "cli/strokes_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/number_check.hpp"
#include "cli/output.hpp"
#include "cli/picture_options.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/strokes_report.hpp"
#include "io/export_net.hpp"
#include "io/picture.hpp"
#include "io/read_strokes.hpp"
#include "io/render.hpp"
#include "strokes/face_net.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::vector<std::string> inputs;
  Output output;
  strokes::BuildOptions build;
  std::string picture, map = "shade";
  PictureRequest view;
  double mesh_tolerance_mm = io::ExportOptions{}.tolerance_mm;
  bool json = false;
};

io::Overwrite overwrite(const Request& request) {
  return request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never;
}

std::vector<model::Stroke> read_all(const Request& request) {
  std::vector<model::Stroke> strokes;
  for (const std::string& input : request.inputs)
    for (model::Stroke& stroke : io::read_strokes(input)) strokes.push_back(std::move(stroke));
  return strokes;
}

void check_request(const Request& request) {
  const bool smooth = request.build.method == strokes::Method::smooth;
  if (!smooth && (request.build.fair || request.build.tolerance_mm))
    throw std::invalid_argument("--fair and --within belong to the smooth method");
  check_output(request.output, request.inputs.front(), io::export_extensions());
  if (request.picture.empty()) return;
  check_output({request.picture, request.output.overwrite}, request.inputs.front(), {".png"});
  io::map_from_name(request.map);
  picture_options(request.view);
}

void draw(Context& context, const Request& request, const model::FaceNet& net) {
  io::RenderOptions options = picture_options(request.view);
  options.map = io::map_from_name(request.map);
  Progress progress(context, "rendering " + request.picture);
  options.on_progress = [&progress](double fraction) { progress.update(fraction); };
  io::write_png(io::render(model::bezier_faces(net), options), request.picture, overwrite(request));
}

// Faces of a construction are where they should be up to rounding, and so are their normals where
// patches join smoothly.
constexpr double allowed_gap_mm = 1e-6, allowed_angle_deg = 1e-6, any_angle_deg = 180.0;

double allowed_angle(const strokes::SurfaceBuild& build) {
  return build.method == strokes::Method::smooth ? allowed_angle_deg : any_angle_deg;
}

void run(Context& context, const Request& request) {
  check_request(request);
  const std::vector<model::Stroke> strokes = read_all(request);
  std::optional<strokes::SurfaceBuild> build;
  {
    const Progress progress(context, "inserting strokes");
    build = strokes::build_surface(strokes, request.build);
  }
  const model::FaceNet net = strokes::face_net(
      build->surface.net, std::filesystem::path(request.inputs.front()).stem().string());
  StrokesReport report{&strokes, &*build, &net, {}, {}};
  {
    const Progress progress(context, "writing " + request.output.path);
    report.check = model::check_face_net(net);
    report.findings =
        model::face_net_findings(net, report.check, allowed_gap_mm, allowed_angle(*build));
    add_stroke_findings(report);
    io::ExportOptions options;
    options.tolerance_mm = request.mesh_tolerance_mm;
    options.overwrite = overwrite(request);
    const bool carries_strokes = std::filesystem::path(request.output.path).extension() == ".json";
    io::export_net(net, request.output.path, options,
                   carries_strokes ? strokes_document(report) : "");
  }
  if (!request.picture.empty()) draw(context, request, net);
  if (request.json) {
    print_json(context, strokes_json(report));
  } else {
    *context.out << request.output.path << ": " << strokes_text(report);
  }
  bool rejected = false;
  for (const auto& outcome : build->outcomes)
    rejected |= outcome.rejection != strokes::Rejection::none;
  if (rejected || !report.findings.empty()) context.exit_code = exit_findings;
}

}  // namespace

void add_strokes_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "strokes", "Make a surface of strokes drawn in space",
                  "bodyline strokes examples/strokes.obj -o surface.step --picture surface.png");
  command
      ->add_option("STROKES", request->inputs,
                   fmt::format("Polylines: {}", fmt::join(io::stroke_extensions(), ", ")))
      ->required()
      ->check(CLI::ExistingFile);
  add_output(*command, request->output,
             fmt::format("File to write, its name says the format: {}",
                         fmt::join(io::export_extensions(), ", ")));
  add_patterns(*command, "--boundary", request->build.boundary,
               "Strokes of the boundary; else those called boundary..., or what is found");
  command
      ->add_option("--threshold", request->build.threshold_mm,
                   "Points closer are one, ends closer to a curve are on it, mm; 1/200 of the "
                   "diagonal when left out")
      ->type_name("MM")
      ->check(positive_number());
  const std::map<std::string, strokes::Method> methods{{"smooth", strokes::Method::smooth},
                                                       {"paper", strokes::Method::paper}};
  command
      ->add_option(
          "--method", request->build.method,
          "smooth: strokes fitted, patches joined with one tangent plane; paper: polylines, "
          "patches that meet in creases")
      ->type_name("METHOD")
      ->default_str("smooth")
      ->transform(CLI::CheckedTransformer(methods).description("smooth, paper"));
  command
      ->add_option(
          "--within", request->build.tolerance_mm,
          "Smooth: largest distance of the newest strokes from the surface, mm; a fifth of "
          "the threshold when left out")
      ->type_name("MM")
      ->check(positive_number());
  command->add_flag("--fair", request->build.fair, "Smooth: as fair as --within allows");
  command
      ->add_option("--tolerance", request->mesh_tolerance_mm,
                   "Largest distance of a mesh from the surface, mm")
      ->type_name("MM")
      ->capture_default_str();
  command->add_option("--picture", request->picture, "Picture to draw (.png)")->type_name("FILE");
  command
      ->add_option("--map", request->map,
                   fmt::format("What its colours say: {}", fmt::join(io::map_names(), ", ")))
      ->capture_default_str();
  add_picture_options(*command, request->view);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
