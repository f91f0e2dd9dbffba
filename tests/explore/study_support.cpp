#include "study_support.hpp"

#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace bodyline::testing {

namespace fs = std::filesystem;

std::string study_text(const std::string& base, const std::string& variables,
                       const std::string& metrics, const std::string& sampler,
                       const std::string& rest) {
  return "format = 1\nname = \"test\"\n" + base + "\n[variables]\n" + variables + "\n[metrics]\n" +
         metrics + "\n[sampler]\n" + sampler + "\n" + rest + "\n";
}

explore::Study study_of(const std::string& text) {
  return explore::read_study_text(text, "study.toml", [](const std::string& name) {
    std::ifstream stream(fs::path(BODYLINE_SOURCE_DIR) / "cars" / name, std::ios::binary);
    if (!stream) throw io::InputError(name, 0, "", "does not exist.");
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  });
}

explore::Study small_study(int count, const std::string& rest) {
  return study_of(study_text(
      "model = \"model1.toml\"",
      "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 2.0] }\n"
      "roof = { vary = [\"curve.roof__side_window[1-4].z\"], offset = [-20, 20] }",
      "bending = {}\nheight = {}", "kind = \"random\"\ncount = " + std::to_string(count), rest));
}

std::vector<std::vector<double>> variants(const explore::Study& study,
                                          const explore::DesignSpace& space, int count) {
  const auto source = explore::make_source(study, space);
  std::vector<std::vector<double>> rows;
  for (int k = 0; k < count; ++k) {
    rows.emplace_back(std::size_t(space.column_count()), 0.0);
    source->values(std::uint64_t(k), 1, rows.back());
  }
  return rows;
}

std::string refusal(const std::string& text) {
  try {
    study_of(text);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "bodyline-explore-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace bodyline::testing
