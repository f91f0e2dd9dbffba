#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

/// Pieces of TOML files as this program writes them: with the fewest digits that identify each
/// number. All throw std::invalid_argument for what no reader would accept.
namespace bodyline::io {

/// A name as is_name allows it.
const std::string& valid_name(const std::string& name);

/// A finite number that reads back with the same bits.
std::string toml_number(double value);
std::string toml_numbers(std::span<const double> numbers);

/// Points on one line where they fit, else one to a line.
std::string toml_points(const std::vector<Eigen::Vector3d>& points);

/// A text in quotes; one that holds line ends is written over several lines.
std::string toml_text(const std::string& text);

/// Names in quotes.
std::string toml_names(const std::vector<std::string>& names);

/// Lines of "key = value" under a header.
class TomlLines {
 public:
  void header(const std::string& name) { text_ += (text_.empty() ? "[" : "\n[") + name + "]\n"; }
  void line(const std::string& key, const std::string& value) {
    text_ += key + " = " + value + "\n";
  }
  void note(const std::string& note) {
    if (!note.empty()) line("note", toml_text(note));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace bodyline::io
