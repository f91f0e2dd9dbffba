#include "cli/deviation_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/deviation_text.hpp"
#include "cli/load_model.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/scan_target.hpp"
#include "cli/stage_option.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model, stage = "body";
  ScanTarget target;
  bool json = false;
};

void run(Context& context, const Request& request) {
  const model::Model model = load_model(context, request.model);
  const PlacedScan placed = place_scan(context, request.target, model);
  optimize::DeviationOptions options;
  options.stage = stage_from_name(request.stage);
  options.most_points = request.target.most_points;
  const optimize::Deviation deviation =
      optimize::measure_deviation(model, placed.scan, placed.pose, options);
  if (request.json) {
    print_json(context, {{"scan", placed.words},
                         {"pose", pose_json(placed.pose)},
                         {"distance_mm", distances_json(deviation.distances)},
                         {"unseen_patches", deviation.unseen_patches},
                         {"faces", faces_json(deviation)}});
    return;
  }
  *context.out << placed.words << "\n\n" << deviation_table(deviation);
  if (!deviation.unseen_patches.empty())
    *context.out << fmt::format("Hardly seen: {}\n", fmt::join(deviation.unseen_patches, ", "));
}

}  // namespace

void add_deviation_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "deviation", "Measure how far a scan lies from a body",
                  "bodyline deviation fitted.toml scan.ply");
  add_model(*command, request->model);
  add_scan_target(*command, request->target);
  add_stage(*command, request->stage);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
