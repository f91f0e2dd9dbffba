#pragma once

#include <string>
#include <vector>

/// Pieces that the reports share, each HTML text.
namespace bodyline::io {

/// A whole page around its sections, with the style sheet and the scripts.
std::string html_page(const std::string& title, const std::string& sections);

/// A key number; `note` stands below it. `value` and `note` are markup, `label` too.
std::string html_tile(const std::string& label, const std::string& value, const std::string& note,
                      bool warning = false);

/// "begin: a, b, c." as a paragraph of a class; empty without names, which are escaped.
std::string html_names_sentence(const std::string& begin, const std::vector<std::string>& names,
                                const char* kind);

/// The command line that repeats a run, and the version of the program.
std::string html_repeat_section(const std::string& command);

}  // namespace bodyline::io
