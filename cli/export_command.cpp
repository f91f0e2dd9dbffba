#include "cli/export_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/stage_option.hpp"
#include "io/export.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model;
  Output output;
  std::string stage = "body";
  double tolerance_mm = io::ExportOptions{}.tolerance_mm;
};

std::string file_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

io::ExportOptions export_options(const Request& request) {
  io::ExportOptions options;
  options.stage = stage_from_name(request.stage);
  options.tolerance_mm = request.tolerance_mm;
  options.overwrite = request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never;
  const bool carries_model = std::filesystem::path(request.output.path).extension() == ".json";
  if (carries_model) options.model_text = file_text(request.model);
  return options;
}

std::string report_text(const io::ExportReport& report) {
  std::string text = fmt::format("{} faces", report.faces);
  if (report.triangles > 0) text += fmt::format(", {} triangles", report.triangles);
  if (report.max_deviation_mm > 0.0) {
    text += fmt::format(", at most {:.2g} mm from the body", report.max_deviation_mm);
  }
  if (!report.not_polynomial.empty()) {
    text += fmt::format(", {} faces approximated: {}", report.not_polynomial.size(),
                        fmt::join(report.not_polynomial, ", "));
  }
  return text;
}

void run(Context& context, const Request& request) {
  check_output(request.output, request.model, io::export_extensions());
  const io::ExportOptions options = export_options(request);
  const model::Model model = load_model(context, request.model);
  io::ExportReport report;
  {
    const Progress progress(context, "writing " + request.output.path);
    report = io::export_body(model, request.output.path, options);
  }
  *context.out << fmt::format("{}: {}\n", request.output.path, report_text(report));
}

}  // namespace

void add_export_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "export", "Write a model for CAD systems and viewers",
                  "bodyline export cars/model1.toml -o model1.step");
  add_model(*command, request->model);
  add_output(*command, request->output,
             fmt::format("File to write, its name says the format: {}",
                         fmt::join(io::export_extensions(), ", ")));
  add_stage(*command, request->stage);
  command
      ->add_option("--tolerance", request->tolerance_mm,
                   "Largest distance of a mesh from the body, mm")
      ->type_name("MM")
      ->capture_default_str();
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
