#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace bodyline::io {

/// A file that cannot be used. `what()` is one line: "FILE:LINE: KEY: sentence", without LINE or
/// KEY where there is none.
class InputError : public std::runtime_error {
 public:
  /// `line` counts from 1, 0 when the error belongs to no line; `key` is a dotted path such as
  /// "patches.hood.cut.u", empty when the error belongs to no key.
  InputError(std::string file, int line, std::string key, std::string sentence)
      : std::runtime_error(message(file, line, key, sentence)),
        file_(std::move(file)),
        line_(line),
        key_(std::move(key)),
        sentence_(std::move(sentence)) {}

  const std::string& file() const { return file_; }
  int line() const { return line_; }
  const std::string& key() const { return key_; }
  const std::string& sentence() const { return sentence_; }

 private:
  static std::string message(const std::string& file, int line, const std::string& key,
                             const std::string& sentence) {
    std::string text = file;
    if (line > 0) text.append(":").append(std::to_string(line));
    text.append(": ");
    if (!key.empty()) text.append(key).append(": ");
    return text.append(sentence);
  }

  std::string file_;
  int line_;
  std::string key_;
  std::string sentence_;
};

/// Something in a file that is accepted but that its author should know.
struct Warning {
  std::string file;
  int line = 0;
  std::string key;
  std::string sentence;

  /// "FILE:LINE: KEY: sentence"
  std::string text() const {
    return file + ":" + std::to_string(line) + ": " + key + ": " + sentence;
  }
};

}  // namespace bodyline::io
