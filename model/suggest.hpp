#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bodyline::model {

/// Number of single-character insertions, deletions and replacements between two words.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance to `name`; empty when there are none.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace bodyline::model
