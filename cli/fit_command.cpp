#include "cli/fit_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "cli/bounds_options.hpp"
#include "cli/deviation_text.hpp"
#include "cli/fit_report.hpp"
#include "cli/interrupt.hpp"
#include "cli/load_model.hpp"
#include "cli/number_check.hpp"
#include "cli/output.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/report_options.hpp"
#include "cli/scan_target.hpp"
#include "cli/template_text.hpp"
#include "io/read_model.hpp"
#include "io/write_model.hpp"
#include "optimize/deviation.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/scan_fit_target.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string start;
  ScanTarget target;
  BoundsRequest bounds;
  Output output;
  optimize::FitOptions options;
  std::string algorithm = optimize::algorithm_name(optimize::FitOptions{}.algorithm);
  ReportRequest report;
  bool json = false;
};

optimize::FitResult fit(Context& context, const PlacedScan& placed, const Bounds& bounds,
                        const model::Model& start, optimize::FitOptions options) {
  const Interrupt interrupt;
  Progress progress(context, "fitting");
  options.should_stop = [&] { return interrupt.requested(); };
  options.on_progress = [&](const optimize::FitProgress& step) {
    progress.update(-1.0, fmt::format("{} {} of {}, median distance {:.2f} mm", step.phase,
                                      step.round, step.rounds, step.distance));
  };
  std::vector<optimize::FitTargetMaker> targets{optimize::scan_fit_target(
      placed.scan, placed.pose, options.coarse_points, options.fine_points)};
  if (!bounds.dimensions.empty())
    targets.push_back(optimize::dimension_target(start, bounds.dimensions));
  if (!bounds.points.empty()) targets.push_back(optimize::hard_point_target(bounds.points));
  return optimize::fit_body(targets, start, options);
}

nlohmann::ordered_json rounds_json(const optimize::FitResult& result) {
  nlohmann::ordered_json rounds = nlohmann::ordered_json::array();
  for (const optimize::FitProgress& round : result.history)
    rounds.push_back({{"phase", round.phase},
                      {"round", round.round},
                      {"median_mm", round.distance},
                      {"seconds", round.seconds}});
  return rounds;
}

void print_result(Context& context, const Request& request, const PlacedScan& placed,
                  const Bounds& bounds, const optimize::FitResult& result,
                  const optimize::Deviation& deviation, double seconds) {
  const BoundsKept kept = measure_bounds(bounds, result.model);
  if (request.json) {
    print_json(context, {{"status", optimize::status_words(result.status)},
                         {"scan", placed.words},
                         {"pose", pose_json(placed.pose)},
                         {"distance_mm", distances_json(deviation.distances)},
                         {"unseen_patches", deviation.unseen_patches},
                         {"folded", result.folded_faces},
                         {"dimensions", dimensions_json(bounds, kept)},
                         {"hard_points", hard_points_json(bounds, kept)},
                         {"faces", faces_json(deviation)},
                         {"rounds", rounds_json(result)},
                         {"seconds", seconds}});
    return;
  }
  std::string text = fmt::format("{}\n{}\n\n{}", placed.words,
                                 optimize::status_words(result.status), deviation_table(deviation));
  if (!deviation.unseen_patches.empty()) {
    text += fmt::format("Hardly seen by the scan, held by fairness alone: {}\n",
                        fmt::join(deviation.unseen_patches, ", "));
  }
  text += bounds_text(bounds, kept);
  for (const std::string& face : result.folded_faces) text += "still folded: " + face + "\n";
  text += fmt::format("{:.1f} s\nfitted model: {}\n", seconds, request.output.path);
  if (request.report.wanted()) text += "report: " + request.report.output.path + "\n";
  *context.out << text;
}

void run(Context& context, Request& request) {
  const auto begin = std::chrono::steady_clock::now();
  request.options.algorithm = optimize::algorithm_from_name(request.algorithm);
  check_output(request.output, request.target.path, {".toml"});
  check_report(request.report, request.output.overwrite, request.target.path);
  const model::Model start = request.start.empty()
                                 ? io::read_model_text(template_text(), "the template")
                                 : load_model(context, request.start);
  const Bounds bounds = read_bounds(request.bounds, start);
  const PlacedScan placed = place_scan(context, request.target, start);
  optimize::FitResult result = fit(context, placed, bounds, start, request.options);
  result.model.name = std::filesystem::path(request.output.path).stem().string();
  io::write_model(result.model, request.output.path,
                  request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  optimize::DeviationOptions measuring;
  measuring.most_points = request.target.most_points;
  const optimize::Deviation deviation =
      optimize::measure_deviation(result.model, placed.scan, placed.pose, measuring);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (request.report.wanted()) {
    io::FitReport report =
        deviation_report(result.model, measuring.stage, placed, deviation, request.report);
    add_fit(report, start, result);
    write_report(context, report, request.report);
  }
  print_result(context, request, placed, bounds, result, deviation, seconds);
  if (!result.folded_faces.empty()) context.exit_code = exit_findings;
}

void add_weights(CLI::App& command, optimize::FitOptions& options) {
  command
      .add_option("--fairness", options.bending,
                  "Weight of the bending energy against the mean squared distance in mm^2")
      ->check(non_negative_number())
      ->capture_default_str();
  command.add_option("--max-cut", options.bounds.max_cut, "Widest strip that joints may take")
      ->check(number_between(0.01, 0.45))
      ->capture_default_str();
}

}  // namespace

void add_fit_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command = add_command(program, "fit", "Fit the body to a scan of a car",
                                        "bodyline fit scan.ply -o car.toml");
  add_scan_target(*command, request->target);
  command->add_option("--start", request->start, "Model to start from; the template when left out")
      ->type_name("MODEL")
      ->check(CLI::ExistingFile);
  add_bounds_options(*command, request->bounds);
  add_output(*command, request->output, "Fitted model, .toml");
  add_report_options(*command, request->report);
  add_weights(*command, request->options);
  command
      ->add_option("--algorithm", request->algorithm,
                   "Of the search in each round: nlopt-lbfgs or ceres-lbfgs")
      ->check(CLI::IsMember({"nlopt-lbfgs", "ceres-lbfgs"}))
      ->capture_default_str();
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
