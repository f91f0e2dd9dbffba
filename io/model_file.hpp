#pragma once

#include <toml++/toml.h>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace bodyline::io {

/// A parsed model file: its TOML tree, and the line on which each key stands. Keys are dotted paths
/// with elements of arrays counted from 0: "curves.grille__hood.points[2]".
class ModelFile {
 public:
  /// Parses the text. Throws InputError for what is not TOML; `name` stands for the file in
  /// messages.
  ModelFile(std::string_view text, std::string name);

  const std::string& name() const { return name_; }
  const toml::table& root() const { return root_; }

  /// Line of a key, or of the longest known part of it that ends at a dot or bracket; 1 when
  /// nothing is known.
  int line_of(std::string_view key) const;

  /// Throws InputError at the key's line.
  [[noreturn]] void fail(const std::string& key, const std::string& sentence) const;

 private:
  void record(const toml::node& node, const std::string& path);

  std::string name_;
  toml::table root_;
  std::map<std::string, int, std::less<>> lines_;
};

}  // namespace bodyline::io
