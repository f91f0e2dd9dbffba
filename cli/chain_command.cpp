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

namespace bodyline::cli {
namespace {

constexpr double picture_tolerance_mm = 0.01;

struct Request {
  std::string chain;
  Output output;  // nothing is written when its path is empty
  bool fair = false;
  std::vector<std::string> vary, hold;
  double within = optimize::ChainProblemOptions{}.within;
  double tolerance_mm = 1e-3;
  PictureRequest picture;
  std::string map = "shade";
  std::optional<double> range;
};

std::string extension(const Request& request) {
  return std::filesystem::path(request.output.path).extension().string();
}

io::Overwrite overwrite(const Request& request) {
  return request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never;
}

optimize::FairChainResult tune(Context& context, const model::PatchChain& chain,
                               const Request& request) {
  optimize::FairChainOptions options;
  if (!request.vary.empty()) options.vary = request.vary;
  options.hold = request.hold;
  options.problem.within = request.within;
  const WatchedSearch watched(context, options.search);
  return optimize::fair_chain(chain, options);
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
    const optimize::FairChainResult result = tune(context, chain, request);
    chain = result.chain;
    text = fair_chain_text(result) + "\n";
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

void run_curves(Context& context, const io::ChainFile& file, const Request& request) {
  const auto& chain = std::get<model::CurveChain>(file.chain);
  if (request.fair) throw std::invalid_argument("--fair tunes chains of patches, not of curves");
  if (extension(request) == ".toml") {
    io::write_chain(file, request.output.path, overwrite(request));
  } else if (!request.output.path.empty()) {
    const io::RenderOptions options = picture_options(request.picture);
    io::write_file(request.output.path,
                   io::chain_svg(chain, options.view, options.width, options.height),
                   overwrite(request));
  }
  *context.out << chain_joins_text(chain);
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
  command.add_flag("--fair", request.fair, "Tune the chain until its patches bend least");
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
