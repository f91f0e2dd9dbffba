#include "cli/load_model.hpp"

#include "io/read_model.hpp"

namespace bodyline::cli {

void print_warnings(Context& context, const std::vector<io::Warning>& warnings) {
  if (context.quiet) return;
  for (const io::Warning& warning : warnings) {
    *context.err << "bodyline: warning: " << warning.text() << "\n";
  }
}

model::Model load_model(Context& context, const std::filesystem::path& path) {
  std::vector<io::Warning> warnings;
  model::Model model = io::read_model(path, &warnings);
  print_warnings(context, warnings);
  return model;
}

}  // namespace bodyline::cli
