#include "cli/stage_option.hpp"

#include <stdexcept>

namespace bodyline::cli {

model::Stage stage_from_name(const std::string& name) {
  for (const model::Stage stage : {model::Stage::base, model::Stage::kept, model::Stage::body}) {
    if (name == model::stage_name(stage)) return stage;
  }
  throw std::invalid_argument("'" + name + "' is not a stage; the stages are base, kept and body");
}

CLI::Option* add_stage(CLI::App& command, std::string& stage) {
  return command
      .add_option("--stage", stage,
                  "base: whole patches; kept: patches cut back; body: everything closed")
      ->type_name("STAGE")
      ->capture_default_str();
}

}  // namespace bodyline::cli
