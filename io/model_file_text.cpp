#include "io/model_file_text.hpp"

#include <fstream>

#include <algorithm>

#include "io/input_error.hpp"

namespace bodyline::io {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool is_beyond_ascii(char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; }
bool is_white_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Walks once over a TOML text. Past the first syntax error its idea of what is a string may differ
/// from the parser's, which stops there.
class TextCheck {
 public:
  TextCheck(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void run() {
    if (follows(byte_order_mark)) position_ = byte_order_mark.size();
    while (!at_end()) {
      const char c = take();
      if (c == '#') {
        skip_comment();
      } else if (c == '"' || c == '\'') {
        check_string(c);
      } else {
        check_outside_strings(c);
      }
    }
  }

 private:
  bool at_end() const { return position_ >= text_.size(); }
  bool follows(std::string_view word) const { return text_.substr(position_).starts_with(word); }

  char take() {
    const char c = text_[position_++];
    if (c == '\n') ++line_;
    return c;
  }

  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(file_, line_, "", sentence);
  }

  void check_outside_strings(char c) {
    if (is_beyond_ascii(c)) {
      fail(
          "holds a character outside ASCII; such characters may stand only in quotes and "
          "comments.");
    }
    if (c == '[' || c == '{') ++nesting_;
    if (c == ']' || c == '}') --nesting_;
    if (nesting_ > deepest_nesting) {
      fail("brackets are nested more than " + std::to_string(deepest_nesting) +
           " deep; a model file needs no more than 2.");
    }
    // What ends a value for the parser; it looks ahead to there, quotes or not.
    if (is_white_space(c) || c == ',' || c == ']' || c == '}') {
      within_word_ = false;
    } else if (c != '[' && c != '{') {
      within_word_ = true;
    }
    if (c == '.') ++dots_;
    if (std::string_view("=,\n[]{}").find(c) != std::string_view::npos) dots_ = 0;
    if (dots_ > longest_dotted_key) {
      fail("a key has more than " + std::to_string(longest_dotted_key) +
           " dots; a model file needs no more than 2.");
    }
  }

  void skip_comment() {
    while (!at_end() && text_[position_] != '\n') take();
  }

  void check_string(char quote) {
    const std::size_t start = position_;
    skip_string(quote);
    const std::string_view string = text_.substr(start, position_ - start);
    if (within_word_ && std::any_of(string.begin(), string.end(), is_beyond_ascii)) {
      fail(
          "holds a character outside ASCII in quotes that follow other characters; put a space "
          "before them.");
    }
    within_word_ = true;
  }

  void skip_string(char quote) {
    const std::string fence(2, quote);
    const bool several_lines = follows(fence);
    if (several_lines) position_ += 2;
    while (!at_end()) {
      if (!several_lines && text_[position_] == '\n') return;
      const char c = take();
      if (c == '\\' && quote == '"') {
        skip_escape(several_lines);
      } else if (c == quote && !several_lines) {
        return;
      } else if (c == quote && follows(fence)) {
        position_ += 2;
        // Up to two quotes may precede the closing three.
        while (!at_end() && text_[position_] == quote) ++position_;
        return;
      }
    }
  }

  /// What a backslash takes with it: one character, or all white space across line ends.
  void skip_escape(bool several_lines) {
    if (at_end()) return;
    take();
    while (several_lines && is_white_space(text_[position_ - 1]) && !at_end() &&
           is_white_space(text_[position_])) {
      take();
    }
    const char before = text_[position_ - 1];
    const bool continued = is_white_space(before) && !at_end() && is_beyond_ascii(text_[position_]);
    if (several_lines && (continued || is_beyond_ascii(before))) {
      fail("after a backslash the text must go on with an ASCII character.");
    }
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t position_ = 0;
  int line_ = 1;
  int nesting_ = 0;
  int dots_ = 0;
  bool within_word_ = false;
};

}  // namespace

void check_text_limits(std::string_view text, const std::string& file) {
  if (text.size() > longest_file) {
    throw InputError(file, 0, "",
                     "holds more than " + std::to_string(longest_file) +
                         " bytes, the most that a model file may have.");
  }
  TextCheck(text, file).run();
}

std::string read_file_text(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status)) {
    throw InputError(path.string(), 0, "", "does not exist.");
  }
  if (std::filesystem::is_directory(path, status)) {
    throw InputError(path.string(), 0, "", "is a folder, not a model file.");
  }
  std::ifstream stream(path, std::ios::binary);
  // One byte more than allowed, so that the check of the length sees a file that is too long.
  std::string text(longest_file + 1, '\0');
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) {
    throw InputError(path.string(), 0, "", "cannot be read.");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace bodyline::io
