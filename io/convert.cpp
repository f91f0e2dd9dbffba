#include "io/convert.hpp"

#include <fstream>
#include <sstream>

#include "io/nets_json.hpp"
#include "io/read_model.hpp"
#include "io/write_model.hpp"

namespace bodyline::io {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw InputError(path.string(), 0, "", "cannot be read.");
  return text.str();
}

}  // namespace

void convert(const std::filesystem::path& from, const std::filesystem::path& to,
             Overwrite overwrite, std::vector<Warning>* warnings) {
  if (to.extension() != ".toml")
    throw InputError(to.string(), 0, "", "is not a model file; its name must end in .toml.");
  if (from.extension() == ".toml") {
    write_model(read_model(from, warnings), to, overwrite);
    return;
  }
  if (from.extension() != ".json")
    throw InputError(from.string(), 0, "",
                     "is of no format that carries a model; those are .toml and .json.");
  const std::string text = model_text_from_json(read_text(from), from.string());
  read_model_text(text, from.string(), warnings);  // refuses what is not a model
  write_file(to, text, overwrite);
}

}  // namespace bodyline::io
