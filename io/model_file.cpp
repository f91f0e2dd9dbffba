#include "io/model_file.hpp"

#include "io/input_error.hpp"
#include "io/model_file_names.hpp"
#include "io/model_file_text.hpp"

namespace bodyline::io {
namespace {

/// The parser's words as one sentence on one line.
std::string sentence_of(const toml::parse_error& error) {
  std::string sentence = "not valid TOML: ";
  for (const char c : error.description()) {
    const auto code = static_cast<unsigned char>(c);
    sentence += code < 0x20 || code == 0x7f ? ' ' : c;
  }
  if (!sentence.ends_with('.')) sentence += '.';
  return sentence;
}

}  // namespace

ModelFile::ModelFile(std::string_view text, std::string name) : name_(std::move(name)) {
  check_text_limits(text, name_);
  try {
    root_ = toml::parse(text, std::string_view(name_));
  } catch (const toml::parse_error& error) {
    throw InputError(name_, static_cast<int>(error.source().begin.line), "", sentence_of(error));
  }
  record(root_, "");
}

void ModelFile::record(const toml::node& node, const std::string& path) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      const std::string inner = (path.empty() ? "" : path + ".") + std::string(key.str());
      lines_.emplace(inner, static_cast<int>(key.source().begin.line));
      record(value, inner);
    }
  } else if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      const toml::node& element = *array->get(i);
      const std::string inner = path + "[" + std::to_string(i) + "]";
      lines_.emplace(inner, static_cast<int>(element.source().begin.line));
      record(element, inner);
    }
  }
}

int ModelFile::line_of(std::string_view key) const {
  while (!key.empty()) {
    const auto known = lines_.find(key);
    if (known != lines_.end() && known->second > 0) return known->second;
    const std::size_t end = key.find_last_of(".[");
    key = key.substr(0, end == std::string_view::npos ? 0 : end);
  }
  return 1;
}

void ModelFile::fail(const std::string& key, const std::string& sentence) const {
  std::string printable;
  for (const char c : key) printable += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  throw InputError(name_, line_of(key), printable, sentence);
}

}  // namespace bodyline::io
