#include "cli/scan_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/deviation_text.hpp"
#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/pose_option.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "io/write_scan.hpp"
#include "optimize/random_pose.hpp"
#include "optimize/simulate_scan.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Request {
  std::string model;
  Output output;
  optimize::SimulateOptions options;
  std::string pose, missing = "none";
  bool json = false;
};

model::Pose chosen_pose(const Request& request) {
  if (request.pose.empty()) return {};
  if (request.pose == "random") return optimize::random_pose(request.options.seed);
  return pose_from_text(request.pose);
}

void print_result(Context& context, const Request& request, std::size_t points) {
  const model::Pose& pose = request.options.pose;
  if (request.json) {
    print_json(
        context,
        Json{{"points", points}, {"pose", pose_json(pose)}, {"pose_option", pose_text(pose)}});
  } else {
    *context.out << fmt::format("{}: {} points, pose {}\n", request.output.path, points,
                                pose_text(pose));
  }
}

void run(Context& context, Request& request) {
  check_output(request.output, request.model, {".ply"});
  request.options.pose = chosen_pose(request);
  request.options.missing = optimize::missing_from_name(request.missing);
  const model::Model model = load_model(context, request.model);
  model::Scan scan;
  {
    const Progress progress(context, "scanning " + request.model);
    scan = optimize::simulate_scan(model, request.options);
    io::write_scan(scan, request.output.path,
                   request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  }
  print_result(context, request, scan.points.size());
}

void add_scanner_options(CLI::App& command, Request& request) {
  optimize::SimulateOptions& options = request.options;
  command.add_option("--points", options.points, "Points on the whole body")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--noise", options.noise_mm, "Standard deviation along each axis, mm")
      ->type_name("MM")
      ->capture_default_str();
  command.add_option("--outliers", options.outliers, "Part of the points that lie anywhere")
      ->type_name("F")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Another seed gives another scan")
      ->type_name("S")
      ->capture_default_str();
  command
      .add_option("--pose", request.pose,
                  "Pose that takes the scan back to the model: random, or "
                  "rx,ry,rz,tx,ty,tz,scale in degrees and mm")
      ->type_name("POSE");
  command
      .add_option("--missing", request.missing,
                  "What the scanner does not see: left, the left side; holes, random places")
      ->type_name("PART")
      ->capture_default_str();
}

}  // namespace

void add_scan_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "scan", "Simulate a scanner: points on a model",
                  "bodyline scan cars/model1.toml -o points.ply --points 20000 --noise 1 "
                  "--outliers 0.1 --pose random");
  add_model(*command, request->model);
  add_output(*command, request->output, "Points to write (.ply)");
  add_scanner_options(*command, *request);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
