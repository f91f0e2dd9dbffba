#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "explore/study.hpp"
#include "io/input_error.hpp"

namespace bodyline::explore {

/// Gives the text of a file that a study names. Throws io::InputError.
using ReadText = std::function<std::string(const std::string& name)>;

/// Reads a study (docs/exploring.md) and the models and lists that it names, relative to its
/// folder, and checks that it can be carried out. Throws io::InputError with file, line and key.
Study read_study(const std::filesystem::path& path);

/// The same for a text in memory; `path` stands for the file in messages, and its folder for that
/// of the scans that the study names.
Study read_study_text(const std::string& text, const std::filesystem::path& path,
                      const ReadText& read);

}  // namespace bodyline::explore
