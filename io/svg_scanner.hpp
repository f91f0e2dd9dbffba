#pragma once

#include <string_view>

namespace bodyline::io {

/// Takes numbers and words off the front of an attribute of an SVG file. All throw
/// std::invalid_argument with a sentence when something else stands there.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : rest_(text) {}

  /// Whether only blanks are left; takes them.
  bool at_end();
  /// Takes blanks, and one comma among them.
  void skip_separator();
  /// Whether a number stands next.
  bool at_number();
  double number();
  /// A lone 0 or 1, which need not be parted from what follows.
  bool flag();
  /// The next character that is no blank.
  char character();
  /// Letters up to something else; may be empty.
  std::string_view word();
  std::string_view rest() const { return rest_; }

 private:
  void skip_blanks();
  std::string_view rest_;
};

}  // namespace bodyline::io
