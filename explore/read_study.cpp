#include "explore/read_study.hpp"

#include <algorithm>
#include <bit>
#include <fstream>

#include "explore/measured_files.hpp"
#include "explore/study_check.hpp"
#include "explore/study_error.hpp"
#include "explore/study_tables.hpp"
#include "io/model_file_lookup.hpp"
#include "io/read_model.hpp"
#include "model/face_rule.hpp"

namespace bodyline::explore {
namespace {

using io::FileTable;

constexpr int known_format = 1;
constexpr std::size_t most_models = 100;
constexpr int most_block_rows = 1 << 16;
constexpr int least_thumbnail = 64, most_thumbnail = 1024;

void check_format(const FileTable& root) {
  const int format = root.integer("format");
  if (format == known_format) return;
  root.fail("format", "is " + std::to_string(format) + "; this program reads format " +
                          std::to_string(known_format) + ".");
}

// The models that variants start from, by the names of their files.
std::vector<std::string> read_base(const FileTable& root, Study& study) {
  int given = 0;
  for (const char* key : {"model", "choice", "blend"}) given += root.has(key) ? 1 : 0;
  if (given != 1) {
    root.fail("model",
              "exactly one of \"model\", \"choice\" and \"blend\" says what variants start from.");
  }
  if (root.has("model")) return {root.text("model")};
  study.base = root.has("choice") ? BaseKind::choice : BaseKind::blend;
  return root.texts(study.base == BaseKind::choice ? "choice" : "blend", {2, most_models});
}

void read_models(const std::vector<std::string>& files, const ReadText& read, const FileTable& root,
                 Study& study) {
  for (const std::string& file : files) {
    study.inputs.push_back({file, read(file)});
    BaseModel base{std::filesystem::path(file).stem().string(),
                   io::read_model_text(study.inputs.back().text, file)};
    if (io::find_name(study.models, base.name) >= 0)
      root.fail("", "two models have files of the same name, \"" + base.name + "\".");
    study.models.push_back(std::move(base));
  }
}

void read_checks(const FileTable& root, Study& study) {
  const auto table = root.find_table("checks");
  if (!table) return;
  table->allow_only({"folds"}, "the checks");
  study.checks.folds = table->flag_or("folds", study.checks.folds);
}

void read_keep(const FileTable& root, Study& study) {
  const auto table = root.find_table("keep");
  if (!table) return;
  table->allow_only({"nets", "thumbnails", "compressed", "block"}, "what is kept");
  study.keep.nets = table->flag_or("nets", study.keep.nets);
  study.keep.compressed = table->flag_or("compressed", study.keep.compressed);
  if (table->has("thumbnails"))
    study.keep.thumbnail_width = int(table->whole("thumbnails", least_thumbnail, most_thumbnail));
  if (!table->has("block")) return;
  study.keep.block = int(table->whole("block", 1, most_block_rows));
  if (!std::has_single_bit(unsigned(study.keep.block)))
    table->fail("block", "must be a power of two.");
}

std::string with_full_stop(std::string sentence) {
  if (!sentence.ends_with('.')) sentence += '.';
  return sentence;
}

std::string read_file(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status))
    throw io::InputError(path.string(), 0, "", "does not exist.");
  if (std::filesystem::is_directory(path, status))
    throw io::InputError(path.string(), 0, "", "is a folder, not a file.");
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw io::InputError(path.string(), 0, "", "cannot be read.");
  return text;
}

}  // namespace

Study read_study_text(const std::string& text, const std::filesystem::path& path,
                      const ReadText& read) {
  const io::ModelFile file(text, path.string());
  const FileTable root(file, file.root(), "");
  root.allow_only({"format", "name", "note", "model", "choice", "blend", "variables", "metrics",
                   "constraints", "sampler", "optimizer", "checks", "keep", "nodes"},
                  "a study");
  check_format(root);
  Study study;
  study.name = root.text("name");
  study.note = root.text_or("note", "");
  study.folder = path.parent_path();
  if (root.has("nodes")) study.nodes = int(root.whole("nodes", 8, model::max_nodes));
  if (study.nodes % 8 != 0) root.fail("nodes", "must be a multiple of 8.");
  study.inputs.push_back({path.filename().string(), text});
  read_models(read_base(root, study), read, root, study);
  read_variables(root, study);
  read_metrics(root, study);
  read_constraints(root, study);
  read_choice_of_variants(root, study);
  read_checks(root, study);
  read_keep(root, study);
  if (study.sampler.kind == SamplerKind::list)
    study.inputs.push_back({study.sampler.file, read(study.sampler.file)});
  try {
    check_study(study);
  } catch (const StudyError& error) {
    file.fail(error.key(), with_full_stop(error.what()));
  }
  return study;
}

Study read_study(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  Study study = read_study_text(read_file(path), path,
                                [&](const std::string& name) { return read_file(folder / name); });
  study.files = measured_files(study);
  return study;
}

}  // namespace bodyline::explore
