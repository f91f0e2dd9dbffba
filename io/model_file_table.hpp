#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/model_file.hpp"

namespace bodyline::io {

/// How many elements an array may have.
struct Count {
  std::size_t least = 0;
  std::size_t most = 0;
};

/// One table of a model file, read by key. Every function throws InputError, with the key's line,
/// for a value of the wrong type, count or size, and for a key that is missing where it is
/// required.
class FileTable {
 public:
  FileTable(const ModelFile& file, const toml::table& table, std::string path)
      : file_(&file), table_(&table), path_(std::move(path)) {}

  /// The dotted path of a key of this table, or of the table itself for "".
  std::string key(std::string_view name) const;
  bool has(std::string_view name) const { return table_->contains(name); }
  [[noreturn]] void fail(std::string_view name, const std::string& sentence) const {
    file_->fail(key(name), sentence);
  }

  /// Refuses every key that is not in the list; `what` names the table in the message ("a patch").
  void allow_only(std::initializer_list<std::string_view> names, const std::string& what) const;

  /// The tables in this one, in the order of the file, with their names. Refuses other values and
  /// bad names.
  std::vector<std::pair<std::string, FileTable>> tables() const;
  std::optional<FileTable> find_table(std::string_view name) const;

  std::string text(std::string_view name) const;
  std::string text_or(std::string_view name, const std::string& otherwise) const;
  bool flag_or(std::string_view name, bool otherwise) const;
  int integer(std::string_view name) const;
  std::int64_t whole(std::string_view name, std::int64_t least, std::int64_t most) const;
  /// A finite number of at most `largest` in size; none when the key is missing.
  std::optional<double> find_number(std::string_view name, double largest) const;
  std::vector<std::string> texts(std::string_view name, Count count) const;

  /// A finite number of at most `largest` in size.
  double real(std::string_view name, double largest) const;
  /// Several of them.
  std::vector<double> numbers(std::string_view name, Count count, double largest) const;
  std::array<double, 2> pair_or(std::string_view name, std::array<double, 2> otherwise,
                                double largest) const;

  /// Points in the file's units, times `scale`; every coordinate at most `largest` in size after
  /// that.
  std::vector<Eigen::Vector3d> points(std::string_view name, Count count, double scale,
                                      double largest) const;

 private:
  const toml::node& required(std::string_view name) const;
  const toml::array& array(const toml::node& node, const std::string& path, Count count,
                           const std::string& what) const;
  double number(const toml::node& node, const std::string& path, double scale,
                double largest) const;

  const ModelFile* file_;
  const toml::table* table_;
  std::string path_;
};

}  // namespace bodyline::io
