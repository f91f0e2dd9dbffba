#include "cli/deviation_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/deviation_text.hpp"
#include "cli/fit_report.hpp"
#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/picture_options.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/report_options.hpp"
#include "cli/scan_target.hpp"
#include "cli/stage_option.hpp"
#include "io/picture.hpp"
#include "io/render.hpp"
#include "model/build.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model, stage = "body";
  ScanTarget target;
  Output output;  // no picture when its path is empty
  PictureRequest picture;
  ReportRequest report;
  bool json = false;
};

void write_map(Context& context, const Request& request, const io::FitReport& report) {
  io::RenderOptions options = picture_options(request.picture);
  options.map = io::Map::field;
  options.field = &report.field;
  Progress progress(context, "rendering " + request.output.path);
  options.on_progress = [&progress](double fraction) { progress.update(fraction); };
  io::write_png(io::render(model::build(report.body, report.stage), options), request.output.path,
                request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
}

void run(Context& context, Request& request) {
  check_report(request.report, request.output.overwrite, request.model,
               !request.output.path.empty());
  if (!request.output.path.empty()) check_output(request.output, request.model, {".png"});
  picture_options(request.picture);  // a bad view is told before any work is done
  const model::Model model = load_model(context, request.model);
  const PlacedScan placed = place_scan(context, request.target, model);
  optimize::DeviationOptions options;
  options.stage = stage_from_name(request.stage);
  options.most_points = request.target.most_points;
  const optimize::Deviation deviation =
      optimize::measure_deviation(model, placed.scan, placed.pose, options);
  io::FitReport report = deviation_report(model, options.stage, placed, deviation, request.report);
  if (!request.output.path.empty()) write_map(context, request, report);
  if (request.report.wanted())
    write_report_page(report_page(context, report, request.report), request.report);
  if (request.json) {
    print_json(context, {{"scan", placed.words},
                         {"pose", pose_json(placed.pose)},
                         {"alignment", alignment_json(placed)},
                         {"distance_mm", distances_json(deviation.distances)},
                         {"unseen_patches", deviation.unseen_patches},
                         {"faces", faces_json(deviation)}});
    return;
  }
  *context.out << placed.words << "\n\n" << deviation_table(deviation);
  *context.out << unseen_words(deviation);
  if (!request.output.path.empty()) *context.out << "map: " << request.output.path << "\n";
  if (request.report.wanted()) *context.out << "report: " << request.report.output.path << "\n";
}

}  // namespace

void add_deviation_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "deviation", "Measure how far a scan lies from a body",
                  "bodyline deviation fitted.toml scan.ply");
  add_model(*command, request->model);
  add_scan_target(*command, request->target);
  request->target.reference = "the model";
  add_stage(*command, request->stage);
  add_output(*command, request->output, "Picture of the distances, .png; none when left out")
      ->required(false);
  add_picture_options(*command, request->picture);
  add_report_options(*command, request->report);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
