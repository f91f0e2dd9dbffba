#include "io/model_file_table.hpp"

#include <algorithm>
#include <cmath>

#include "io/model_file_names.hpp"
#include "model/number_text.hpp"

namespace bodyline::io {
namespace {

std::string count_of(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string count_of(Count count, const std::string& what) {
  if (count.least == count.most) return count_of(count.least, what);
  return std::to_string(count.least) + " to " + count_of(count.most, what);
}

/// A value in the words of a message.
std::string described(const toml::node& node) {
  if (const auto* text = node.as_string()) return "the text " + in_quotes(text->get());
  if (const auto* integer = node.as_integer())
    return "the number " + std::to_string(integer->get());
  if (const auto* number = node.as_floating_point())
    return "the number " + model::number_text(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return "an array of " + count_of(array->size(), "value");
  if (node.is_table()) return "a table";
  return "a date or a time";
}

std::string must_be(const std::string& what, const toml::node& node) {
  return "must be " + what + ", but is " + described(node) + ".";
}

}  // namespace

std::string FileTable::key(std::string_view name) const {
  if (name.empty()) return path_;
  return (path_.empty() ? "" : path_ + ".") + std::string(name);
}

const toml::node& FileTable::required(std::string_view name) const {
  const toml::node* node = table_->get(name);
  if (node == nullptr) fail(name, "is required but missing.");
  return *node;
}

void FileTable::allow_only(std::initializer_list<std::string_view> names,
                           const std::string& what) const {
  const std::vector<std::string> allowed(names.begin(), names.end());
  for (const auto& [name, value] : *table_) {
    if (std::find(names.begin(), names.end(), name.str()) != names.end()) continue;
    fail(name.str(), "unknown key of " + what + suggestion(name.str(), allowed) + "; allowed are " +
                         listed(allowed) + ".");
  }
}

std::vector<std::pair<std::string, FileTable>> FileTable::tables() const {
  std::vector<std::pair<toml::source_position, std::pair<std::string, FileTable>>> found;
  for (const auto& [name, value] : *table_) {
    const std::string text(name.str());
    if (!is_name(text)) fail(text, "is not a name: " + std::string(name_rule) + ".");
    if (!value.is_table()) fail(text, must_be("a table", value));
    found.push_back({name.source().begin, {text, FileTable(*file_, *value.as_table(), key(text))}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::pair<std::string, FileTable>> result;
  for (auto& entry : found) result.push_back(std::move(entry.second));
  return result;
}

std::optional<FileTable> FileTable::find_table(std::string_view name) const {
  const toml::node* node = table_->get(name);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) fail(name, must_be("a table", *node));
  return FileTable(*file_, *node->as_table(), key(name));
}

std::string FileTable::text(std::string_view name) const {
  const toml::node& node = required(name);
  if (!node.is_string()) fail(name, must_be("a text in quotes", node));
  return node.as_string()->get();
}

std::string FileTable::text_or(std::string_view name, const std::string& otherwise) const {
  return has(name) ? text(name) : otherwise;
}

bool FileTable::flag_or(std::string_view name, bool otherwise) const {
  if (!has(name)) return otherwise;
  const toml::node& node = required(name);
  if (!node.is_boolean()) fail(name, must_be("true or false", node));
  return node.as_boolean()->get();
}

int FileTable::integer(std::string_view name) const {
  return static_cast<int>(whole(name, 0, 1'000'000));
}

std::int64_t FileTable::whole(std::string_view name, std::int64_t least, std::int64_t most) const {
  const toml::node& node = required(name);
  if (!node.is_integer()) fail(name, must_be("a whole number", node));
  const std::int64_t value = node.as_integer()->get();
  if (value < least || value > most) {
    fail(name, must_be("between " + std::to_string(least) + " and " + std::to_string(most), node));
  }
  return value;
}

double FileTable::real(std::string_view name, double largest) const {
  return number(required(name), key(name), 1.0, largest);
}

const toml::array& FileTable::array(const toml::node& node, const std::string& path, Count count,
                                    const std::string& what) const {
  if (!node.is_array()) file_->fail(path, must_be("an array of " + count_of(count, what), node));
  const toml::array& values = *node.as_array();
  if (values.size() < count.least || values.size() > count.most) {
    file_->fail(path, "must hold " + count_of(count, what) + ", but holds " +
                          std::to_string(values.size()) + ".");
  }
  return values;
}

std::optional<double> FileTable::find_number(std::string_view name, double largest) const {
  if (!has(name)) return std::nullopt;
  return number(required(name), key(name), 1.0, largest);
}

double FileTable::number(const toml::node& node, const std::string& path, double scale,
                         double largest) const {
  if (!node.is_number()) file_->fail(path, must_be("a number", node));
  const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                         : node.as_floating_point()->get();
  if (!std::isfinite(value)) file_->fail(path, must_be("a finite number", node));
  if (std::abs(value * scale) > largest) {
    const std::string limit = model::number_text(largest / scale);
    file_->fail(path, must_be("between -" + limit + " and " + limit, node));
  }
  return value;
}

std::vector<std::string> FileTable::texts(std::string_view name, Count count) const {
  std::vector<std::string> result;
  for (const toml::node& node : array(required(name), key(name), count, "name")) {
    const std::string path = key(name) + "[" + std::to_string(result.size()) + "]";
    if (!node.is_string()) file_->fail(path, must_be("a name in quotes", node));
    result.push_back(node.as_string()->get());
  }
  return result;
}

std::vector<double> FileTable::numbers(std::string_view name, Count count, double largest) const {
  std::vector<double> result;
  for (const toml::node& node : array(required(name), key(name), count, "number")) {
    const std::string path = key(name) + "[" + std::to_string(result.size()) + "]";
    result.push_back(number(node, path, 1.0, largest));
  }
  return result;
}

std::array<double, 2> FileTable::pair_or(std::string_view name, std::array<double, 2> otherwise,
                                         double largest) const {
  if (!has(name)) return otherwise;
  const std::vector<double> values = numbers(name, {2, 2}, largest);
  return {values[0], values[1]};
}

std::vector<Eigen::Vector3d> FileTable::points(std::string_view name, Count count, double scale,
                                               double largest) const {
  std::vector<Eigen::Vector3d> result;
  for (const toml::node& node : array(required(name), key(name), count, "point")) {
    const std::string path = key(name) + "[" + std::to_string(result.size()) + "]";
    const toml::array& coordinates = array(node, path, {3, 3}, "coordinate");
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) {
      const std::string inner = path + "[" + std::to_string(k) + "]";
      point[k] =
          number(*coordinates.get(static_cast<std::size_t>(k)), inner, scale, largest) * scale;
    }
    result.push_back(point);
  }
  return result;
}

}  // namespace bodyline::io
