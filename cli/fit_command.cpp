#include "cli/fit_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "cli/bounds_options.hpp"
#include "cli/drawn_target.hpp"
#include "cli/fit_report.hpp"
#include "cli/fit_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/interrupt_words.hpp"
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
#include "optimize/fit_body.hpp"
#include "optimize/fit_car.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string start;
  ScanTarget scan;  // none when its path is empty
  DrawnRequest drawn;
  BoundsRequest bounds;
  Output output;
  optimize::FitOptions options;
  std::string algorithm = optimize::algorithm_name(optimize::FitOptions{}.algorithm);
  ReportRequest report;
  bool json = false;

  // A file that is read and must not be replaced.
  const std::string& input() const { return scan.path.empty() ? start : scan.path; }
};

void check_request(Request& request) {
  if (request.scan.path.empty() && !request.drawn.wanted()) {
    throw std::invalid_argument(
        "there is nothing to fit to: give a scan, outlines (--views) or lines (--feature)");
  }
  if (request.scan.path.empty() && (!request.scan.pose.empty() || request.scan.unit_mm > 0.0))
    throw std::invalid_argument("--pose and --unit place a scan, and there is none");
  check_output(request.output, request.input(), {".toml"});
  check_report(request.report, request.output.overwrite, request.input());
}

optimize::FitCar car_of(const FittedCar& given) {
  optimize::FitCar car{{}, given.drawn.outlines, given.drawn.features, given.bounds};
  if (given.scan) car.scan = {given.scan->fitted, given.scan->pose};
  return car;
}

optimize::FitResult fit(Context& context, const Interrupt& interrupt, const optimize::FitCar& car,
                        const model::Model& start, optimize::FitOptions options) {
  Progress progress(context, "fitting");
  options.should_stop = [&] { return interrupt.requested(); };
  options.on_progress = [&](const optimize::FitProgress& step) {
    progress.update(-1.0, fmt::format("{} {} of {}, median distance {:.2f} mm", step.phase,
                                      step.round, step.rounds, step.distance));
  };
  options.starts = optimize::fit_starts(car);
  return optimize::fit_body(optimize::fit_targets(car, start), start, options);
}

void print_result(Context& context, const Request& request, const FittedCar& car) {
  if (request.json) {
    print_json(context, fit_json(car));
    return;
  }
  const bool failed = car.result.status == optimize::Status::failed;
  *context.out << fit_text(car) << (failed ? "model as far as it came: " : "fitted model: ")
               << request.output.path << "\n";
}

// Reads and places what is fitted to. Returns the model that the fit starts from.
model::Model read_car(Context& context, const Request& request, FittedCar& car) {
  const InterruptWords words(
      context, "stopped while reading and placing what is to be fitted; nothing was written.");
  model::Model start = request.start.empty() ? io::read_model_text(template_text(), "the template")
                                             : load_model(context, request.start);
  car.bounds = read_bounds(request.bounds, start);
  if (!request.scan.path.empty()) car.scan = place_scan(context, request.scan, start);
  car.drawn = place_drawn(context, request.drawn, car.bounds, start, car.scan);
  return start;
}

// From here on the model is on the disk whatever happens, and is measured at any rate.
void fit_and_measure(Context& context, const Request& request, FittedCar& car) {
  const Interrupt interrupt;
  car.result = fit(context, interrupt, car_of(car), car.drawn.start, request.options);
  car.result.model.name = std::filesystem::path(request.output.path).stem().string();
  io::write_model(car.result.model, request.output.path,
                  request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  optimize::DeviationOptions measuring;
  measuring.most_points = request.scan.most_points;
  if (car.scan) {
    car.deviation =
        optimize::measure_deviation(car.result.model, car.scan->scan, car.scan->pose, measuring);
    car.arches = optimize::arch_gaps(car.result.model, *car.deviation);
  }
  car.kept = measure_drawn(car.drawn, car.result.model);
  car.bounds_kept = optimize::measure_bounds(car.result.model, car.bounds);
}

void make_report(Context& context, const Request& request, const FittedCar& car,
                 const model::Model& start) {
  std::string page;
  {
    const InterruptWords words(
        context, fmt::format("stopped while making the page {}, which was not written; the model "
                             "{} is complete.",
                             request.report.output.path, request.output.path));
    context.out->flush();
    io::FitReport report = fit_report(car, start, request.report);
    page = report_page(context, report, request.report);
  }
  write_report_page(page, request.report);
  if (!request.json) *context.out << "report: " << request.report.output.path << "\n";
}

void run(Context& context, Request& request) {
  const auto begin = std::chrono::steady_clock::now();
  check_request(request);
  request.options.algorithm = optimize::algorithm_from_name(request.algorithm);
  FittedCar car;
  const model::Model start = read_car(context, request, car);
  fit_and_measure(context, request, car);
  car.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  print_result(context, request, car);
  if (has_findings(car)) context.exit_code = exit_findings;
  if (request.report.wanted()) make_report(context, request, car, start);
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
  CLI::App* const command =
      add_command(program, "fit", "Fit the body to a scan or to outlines of a car",
                  "bodyline fit scan.ply -o car.toml");
  add_scan_target(*command, request->scan);
  command->get_option("SCAN")->required(false);
  add_drawn_target(*command, request->drawn);
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
