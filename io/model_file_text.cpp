#include "io/model_file_text.hpp"

#include "io/input_error.hpp"

namespace bodyline::io {
namespace {

/// Walks over a TOML text, stepping over strings and comments. Past the first syntax error its idea
/// of what is a string may differ from the parser's, which stops there.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return position_ >= text_.size(); }
  int line() const { return line_; }

  /// The next character that is neither in a string nor in a comment.
  char next() {
    const char c = take();
    if (c == '#') skip_comment();
    if (c == '"' || c == '\'') skip_string(c);
    return c;
  }

 private:
  char take() {
    const char c = text_[position_++];
    if (c == '\n') ++line_;
    return c;
  }

  bool follows(std::string_view word) const { return text_.substr(position_).starts_with(word); }

  void skip_comment() {
    while (!at_end() && text_[position_] != '\n') take();
  }

  void skip_string(char quote) {
    const std::string fence(2, quote);
    const bool multiline = follows(fence);
    if (multiline) position_ += 2;
    while (!at_end()) {
      if (!multiline && text_[position_] == '\n') return;
      const char c = take();
      if (c == '\\' && quote == '"' && !at_end()) {
        take();
      } else if (c == quote && !multiline) {
        return;
      } else if (c == quote && follows(fence)) {
        position_ += 2;
        // Up to two quotes may precede the closing three.
        while (!at_end() && text_[position_] == quote) ++position_;
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int line_ = 1;
};

}  // namespace

void check_text_limits(std::string_view text, const std::string& file) {
  if (text.size() > longest_file) {
    throw InputError(file, 0, "",
                     "holds more than " + std::to_string(longest_file) +
                         " bytes, the most that a model file may have.");
  }
  int nesting = 0;
  int dots = 0;
  for (Scanner scanner(text); !scanner.at_end();) {
    const int line = scanner.line();
    const char c = scanner.next();
    if (c == '.') ++dots;
    if (c == '=' || c == ',' || c == '\n' || c == '[' || c == ']' || c == '{' || c == '}') dots = 0;
    if (c == '[' || c == '{') ++nesting;
    if (c == ']' || c == '}') --nesting;
    if (nesting > deepest_nesting) {
      throw InputError(file, line, "",
                       "brackets are nested more than " + std::to_string(deepest_nesting) +
                           " deep; a model file needs no more than 2.");
    }
    if (dots > longest_dotted_key) {
      throw InputError(file, line, "",
                       "a key has more than " + std::to_string(longest_dotted_key) +
                           " dots; a model file needs no more than 2.");
    }
  }
}

}  // namespace bodyline::io
