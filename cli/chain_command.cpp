#include "cli/chain_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "cli/chain_text.hpp"
#include "cli/number_check.hpp"
#include "cli/output.hpp"
#include "cli/picture_options.hpp"
#include "cli/progress.hpp"
#include "cli/watched_search.hpp"
#include "io/chain_file.hpp"
#include "io/chain_picture.hpp"
#include "io/export_step.hpp"
#include "io/picture.hpp"
#include "io/render.hpp"
#include "model/chain_faces.hpp"
#include "optimize/fair_chain.hpp"

namespace bodyline::cli {
namespace {

constexpr double picture_tolerance_mm = 0.01;

struct Request {
  std::string chain;
  Output output;  // nothing is written when its path is empty
  bool fair = false;
  std::string measure = "bending";
  std::vector<std::string> vary, hold;
  double within = optimize::ChainProblemOptions{}.within;
  double tolerance_mm = 1e-3;
  PictureRequest picture;
  std::string map = "shade";
  std::optional<double> range;
  double comb_mm = 0.0;
};

std::string extension(const Request& request) {
  return std::filesystem::path(request.output.path).extension().string();
}

io::Overwrite overwrite(const Request& request) {
  return request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never;
}

// The options that chains of patches and of curves share.
template <class FairOptions>
FairOptions fair_options(const Request& request) {
  FairOptions options;
  if (!request.vary.empty()) options.vary = request.vary;
  options.hold = request.hold;
  options.problem.within = request.within;
  return options;
}

void draw(Context& context, const model::PatchChain& chain, const Request& request) {
  io::RenderOptions options = picture_options(request.picture);
  options.map = io::map_from_name(request.map);
  options.curvature_range = request.range;
  Progress progress(context, "rendering " + request.output.path);
  options.on_progress = [&progress](double fraction) { progress.update(fraction); };
  io::write_png(io::render(model::chain_faces(chain, picture_tolerance_mm), options),
                request.output.path, overwrite(request));
}

void write_cad(const model::PatchChain& chain, const Request& request) {
  const auto faces = model::chain_faces(chain, request.tolerance_mm);
  const bool step = extension(request) == ".step" || extension(request) == ".stp";
  const io::CadFile file =
      step ? io::step_file(faces, chain.name) : io::iges_file(faces, chain.name);
  io::write_file(request.output.path, file.text, overwrite(request));
}

void run_patches(Context& context, io::ChainFile& file, const Request& request) {
  model::PatchChain& chain = std::get<model::PatchChain>(file.chain);
  std::string text;
  if (request.fair) {
    if (request.measure != "bending")
      throw std::invalid_argument(
          "--measure of patches is bending; curves know " +
          fmt::format("{}", fmt::join(model::curve_fairness_names(), ", ")));
    auto options = fair_options<optimize::FairChainOptions>(request);
    const WatchedSearch watched(context, options.search);
    const optimize::FairChainResult result = optimize::fair_chain(chain, options);
    chain = result.chain;
    text = chain_tuning_text(result, request.measure) + "\n";
  }
  text += chain_joins_text(chain) + "\n" + chain_variables_text(chain);
  if (extension(request) == ".toml") {
    io::write_chain(file, request.output.path, overwrite(request));
  } else if (extension(request) == ".png") {
    draw(context, chain, request);
  } else if (!request.output.path.empty()) {
    write_cad(chain, request);
  }
  *context.out << text;
}

void run_curves(Context& context, io::ChainFile& file, const Request& request) {
  auto& chain = std::get<model::CurveChain>(file.chain);
  std::string text;
  if (request.fair) {
    auto options = fair_options<optimize::FairCurveChainOptions>(request);
    options.problem.measure = model::curve_fairness(request.measure);
    const WatchedSearch watched(context, options.search);
    const optimize::FairCurveChainResult result = optimize::fair_chain(chain, options);
    chain = result.chain;
    text = chain_tuning_text(result, request.measure) + "\n";
  }
  text += chain_joins_text(chain) + "\n" + chain_variables_text(chain);
  if (extension(request) == ".toml") {
    io::write_chain(file, request.output.path, overwrite(request));
  } else if (!request.output.path.empty()) {
    const io::RenderOptions options = picture_options(request.picture);
    io::write_file(
        request.output.path,
        io::chain_svg(chain, {options.view, options.width, options.height, request.comb_mm}),
        overwrite(request));
  }
  *context.out << text;
}

void run(Context& context, const Request& request) {
  io::ChainFile file = io::read_chain(request.chain);
  const bool patches = std::holds_alternative<model::PatchChain>(file.chain);
  if (!request.output.path.empty()) {
    check_output(request.output, request.chain,
                 patches
                     ? std::vector<std::string>{".toml", ".png", ".step", ".stp", ".iges", ".igs"}
                     : std::vector<std::string>{".toml", ".svg"});
  }
  if (patches) {
    run_patches(context, file, request);
  } else {
    run_curves(context, file, request);
  }
}

void add_options(CLI::App& command, Request& request) {
  command.add_flag("--fair", request.fair, "Tune the chain until it bends least");
  command
      .add_option("--measure", request.measure,
                  fmt::format("What tuning lessens; of curves {}",
                              fmt::join(model::curve_fairness_names(), " or ")))
      ->capture_default_str();
  add_patterns(command, "--vary", request.vary,
               fmt::format("Variables to tune; {} when left out",
                           fmt::join(optimize::FairChainOptions{}.vary, ", ")));
  add_patterns(command, "--hold", request.hold, "Variables to freeze");
  command
      .add_option("--within", request.within,
                  "How far a coordinate of a free control point may move, mm")
      ->type_name("MM")
      ->check(positive_number())
      ->capture_default_str();
  command
      .add_option("--tolerance", request.tolerance_mm,
                  "Largest distance of a CAD file from patches that are no polynomials, mm")
      ->type_name("MM")
      ->check(positive_number())
      ->capture_default_str();
  add_picture_options(command, request.picture);
  command
      .add_option(
          "--comb", request.comb_mm,
          "Draw curvature combs on curves, their teeth this long where the radius is 100 mm")
      ->type_name("MM")
      ->check(positive_number());
  command
      .add_option("--map", request.map,
                  fmt::format("What colours say: {}", fmt::join(io::map_names(), ", ")))
      ->capture_default_str();
  command.add_option("--range", request.range,
                     "Curvature at which the colours of a curvature map end, 1/m or 1/m^2");
}

}  // namespace

void add_chain_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "chain", "Join patches or curves of a family, tune, draw, export them",
                  "bodyline chain examples/hull.toml --fair -o hull.png --map mean-curvature");
  command->add_option("CHAIN", request->chain, "Chain file")->required()->check(CLI::ExistingFile);
  add_output(*command, request->output,
             "File to write: .toml; of patches .png, .step, .iges; of curves .svg")
      ->required(false);
  add_options(*command, *request);
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
