#pragma once

#include <span>
#include <string>
#include <string_view>

/// Names and values as they appear in messages about model files.
namespace bodyline::io {

/// Whether a patch, curve, joint or corner can have this name: a letter, then letters, digits and
/// underscores, at most 64 in all.
bool is_name(std::string_view name);

/// What `is_name` allows, in words.
inline constexpr const char* name_rule =
    "a name is a letter followed by letters, digits and underscores, at most 64 in all";

/// The text in double quotes on one line: control characters replaced, shortened when long.
std::string in_quotes(std::string_view text);

/// ` (did you mean "..."?)` with the most similar candidate, or "" when none is similar.
std::string suggestion(std::string_view wrong, std::span<const std::string> candidates);

/// "a, b, c": the first ten, and how many more there are.
std::string listed(std::span<const std::string> names);

}  // namespace bodyline::io
