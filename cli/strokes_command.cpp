#include "cli/strokes_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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
#include "cli/refine_model.hpp"
#include "cli/strokes_report.hpp"
#include "io/export_net.hpp"
#include "io/picture.hpp"
#include "io/read_model.hpp"
#include "io/read_strokes.hpp"
#include "io/render.hpp"
#include "strokes/face_net.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::vector<std::string> inputs;
  Output output;
  strokes::BuildOptions build;
  std::string refine, patch;
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
  if (request.refine.empty() != request.patch.empty())
    throw std::invalid_argument("--refine and --patch go together");
  if (!request.refine.empty() && !request.build.boundary.empty())
    throw std::invalid_argument("a refined patch has its own boundary: leave out --boundary");
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

/// The surface that was made, and what is to be said of it.
struct Made {
  std::vector<model::Stroke> strokes;
  std::optional<strokes::SurfaceBuild> build;
  model::FaceNet net;
  StrokesReport report;
};

void make_surface(Context& context, const Request& request, Made& made) {
  {
    const Progress progress(context, "inserting strokes");
    made.build = strokes::build_surface(made.strokes, request.build);
  }
  made.net = strokes::face_net(made.build->surface.net,
                               std::filesystem::path(request.inputs.front()).stem().string());
  const Progress progress(context, "checking the surface");
  made.report.check = model::check_face_net(made.net);
  made.report.findings =
      model::face_net_findings(made.net, made.report.check, allowed_gap_mm,
                               made.build->smooth ? allowed_angle_deg : any_angle_deg);
}

void refine(Context& context, const Request& request, Made& made) {
  const Progress progress(context, "refining " + request.patch);
  RefinedModel refined =
      refine_model(io::read_model(request.refine), request.patch, made.strokes, request.build);
  made.report.check = std::move(refined.check);
  made.report.refined = {request.patch, refined.border_before_deg, refined.border_deg};
  made.report.findings =
      model::face_net_findings(refined.net, made.report.check, allowed_gap_mm,
                               std::max(allowed_angle_deg, refined.border_before_deg));
  made.build = std::move(refined.build);
  made.net = std::move(refined.net);
}

void write(Context& context, const Request& request, const Made& made) {
  const Progress progress(context, "writing " + request.output.path);
  io::ExportOptions options;
  options.tolerance_mm = request.mesh_tolerance_mm;
  options.overwrite = overwrite(request);
  const bool carries_strokes = std::filesystem::path(request.output.path).extension() == ".json";
  io::export_net(made.net, request.output.path, options,
                 carries_strokes ? strokes_document(made.report) : "");
}

void run(Context& context, const Request& request) {
  check_request(request);
  Made made;
  made.strokes = read_all(request);
  if (request.refine.empty()) {
    make_surface(context, request, made);
  } else {
    refine(context, request, made);
  }
  made.report.strokes = &made.strokes;
  made.report.build = &*made.build;
  made.report.net = &made.net;
  add_stroke_findings(made.report);
  write(context, request, made);
  if (!request.picture.empty()) draw(context, request, made.net);
  if (request.json) {
    print_json(context, strokes_json(made.report));
  } else {
    *context.out << request.output.path << ": " << strokes_text(made.report);
  }
  bool rejected = false;
  for (const auto& outcome : made.build->outcomes)
    rejected |= outcome.rejection != strokes::Rejection::none;
  if (rejected || !made.report.findings.empty()) context.exit_code = exit_findings;
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
          "Smooth: largest distance of the newest strokes from the surface, mm (not how far points "
          "move, as in fair and chain); a fifth of the threshold when left out")
      ->type_name("MM")
      ->check(positive_number());
  command
      ->add_option("--refine", request->refine,
                   "Model of a body; the strokes refine one of its patches, and the whole body is "
                   "written")
      ->type_name("MODEL")
      ->check(CLI::ExistingFile);
  command->add_option("--patch", request->patch, "Patch to refine, as it is left after its cut")
      ->type_name("NAME");
  command->add_flag(
      "--fair", request->build.fair,
      "Smooth: as fair as --within allows; with --refine that is the displacement, and a "
      "patch that already holds the strokes stays as it is");
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
