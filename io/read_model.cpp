#include "io/read_model.hpp"

#include <algorithm>

#include "io/model_file.hpp"
#include "io/model_file_joining.hpp"
#include "io/model_file_names.hpp"
#include "io/model_file_patches.hpp"
#include "io/model_file_table.hpp"
#include "io/model_file_text.hpp"
#include "io/model_file_warnings.hpp"
#include "model/connect.hpp"
#include "model/factors.hpp"

namespace bodyline::io {
namespace {

constexpr int known_format = 1;

/// Length of a unit in mm. Throws InputError for an unknown unit.
double millimetres_per_unit(const FileTable& root) {
  const std::string unit = root.text_or("units", "mm");
  if (unit == "mm") return 1.0;
  if (unit == "cm") return 10.0;
  if (unit == "m") return model::mm_per_m;
  if (unit == "in") return 25.4;
  root.fail("units", "is " + in_quotes(unit) + "; allowed are \"mm\", \"cm\", \"m\" and \"in\".");
}

void check_format(const FileTable& root) {
  const int format = root.integer("format");
  if (format == known_format) return;
  root.fail("format", "is " + std::to_string(format) + "; this program reads format " +
                          std::to_string(known_format) + ".");
}

std::string with_full_stop(std::string sentence) {
  if (!sentence.ends_with('.')) sentence += '.';
  return sentence;
}

}  // namespace

model::Model read_model_text(std::string_view text, const std::string& name,
                             std::vector<Warning>* warnings) {
  const ModelFile file(text, name);
  const FileTable root(file, file.root(), "");
  root.allow_only({"format", "name", "units", "note", "curves", "patches", "joints", "seams",
                   "corners", "wheels"},
                  "a model file");
  check_format(root);
  model::Model model;
  model.name = root.text("name");
  model.note = root.text_or("note", "");
  read_curves(root, millimetres_per_unit(root), model);
  read_patches(root, model);
  read_joints(root, model);
  read_seams(root, model);
  read_corners(root, model);
  read_wheels(root, model);
  try {
    model::connect(model);
  } catch (const model::ModelError& error) {
    file.fail(error.key(), with_full_stop(error.what()));
  }
  if (warnings != nullptr) append_warnings(file, model, *warnings);
  return model;
}

model::Model read_model(const std::filesystem::path& path, std::vector<Warning>* warnings) {
  return read_model_text(read_file_text(path), path.string(), warnings);
}

}  // namespace bodyline::io
