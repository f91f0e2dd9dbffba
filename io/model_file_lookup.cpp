#include "io/model_file_lookup.hpp"

namespace bodyline::io {

std::vector<std::pair<std::string, FileTable>> entries(const FileTable& root,
                                                       std::string_view name) {
  const auto table = root.find_table(name);
  if (!table) return {};
  auto found = table->tables();
  if (found.size() > most_entries) {
    root.fail(name, "has " + std::to_string(found.size()) + " entries; at most " +
                        std::to_string(most_entries) + " are allowed.");
  }
  return found;
}

}  // namespace bodyline::io
