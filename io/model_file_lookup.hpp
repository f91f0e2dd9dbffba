#pragma once

#include <string>
#include <vector>

#include "io/model_file_names.hpp"
#include "io/model_file_table.hpp"

namespace bodyline::io {

/// Most entries that one table of a model file may have, most elements of an array of names.
inline constexpr std::size_t most_entries = 1000;

/// Position of the item with a name, -1 when there is none.
template <typename Item>
int find_name(const std::vector<Item>& items, const std::string& name) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

/// Position of the item that a value names; refuses an unknown name at `key` of the table. `kind`
/// is "patch" or "curve".
template <typename Item>
int index_of(const std::vector<Item>& items, const std::string& name, const FileTable& table,
             const std::string& key, const std::string& kind) {
  const int index = find_name(items, name);
  if (index >= 0) return index;
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  table.fail(key, "is " + in_quotes(name) + ", but there is no " + kind + " of this name" +
                      suggestion(name, names) + "; known are " +
                      (names.empty() ? "none" : listed(names)) + ".");
}

/// The tables in `name`, at most `most_entries`; none when the key is absent.
std::vector<std::pair<std::string, FileTable>> entries(const FileTable& root,
                                                       std::string_view name);

}  // namespace bodyline::io
