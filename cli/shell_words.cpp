#include "cli/shell_words.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace bodyline::cli {
namespace {

bool is_plain(unsigned char c) {
  return std::isalnum(c) || std::string_view("_-./=,:+@%").find(char(c)) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string text = "'";
  for (const char c : word) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      text += c;
    }
  }
  return text + "'";
}

}  // namespace

std::string shell_words(int argc, const char* const* argv) {
  std::string text = "bodyline";
  for (int k = 1; k < argc; ++k) text += " " + quoted(argv[k]);
  return text;
}

}  // namespace bodyline::cli
