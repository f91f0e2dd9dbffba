#include "cli/output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

namespace bodyline::cli {
namespace {

namespace fs = std::filesystem;

void check_extension(const fs::path& path, const std::vector<std::string>& extensions) {
  if (extensions.empty()) return;
  if (std::find(extensions.begin(), extensions.end(), path.extension()) != extensions.end()) return;
  throw std::invalid_argument(
      fmt::format("{}: the name must end in {}.", path.string(), fmt::join(extensions, ", ")));
}

}  // namespace

CLI::Option* add_output(CLI::App& command, Output& output, const std::string& text) {
  CLI::Option* const option =
      command.add_option("-o,--output", output.path, text)->required()->type_name("FILE");
  command.add_flag("--overwrite", output.overwrite, "Replace the output when it exists");
  return option;
}

void check_output(const Output& output, const fs::path& input,
                  const std::vector<std::string>& extensions) {
  if (output.path.empty()) throw std::invalid_argument("the name of the output is empty.");
  const fs::path path = output.path;
  check_extension(path, extensions);
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw std::invalid_argument(path.string() + ": is a folder; give the name of a file.");
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw std::invalid_argument(path.string() + ": its folder does not exist.");
  }
  if (output.overwrite || !fs::exists(path, error)) return;
  const bool same = fs::equivalent(path, input, error);
  throw std::invalid_argument(fmt::format("{}: {}; --overwrite replaces it.", path.string(),
                                          same ? "is the input" : "exists already"));
}

}  // namespace bodyline::cli
