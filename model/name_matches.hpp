#pragma once

#include <span>
#include <string>

namespace bodyline::model {

/// Whether a name matches a pattern. `*` stands for any run of characters, `?` for one, `[1-2]` for
/// a range of digits; other brackets are taken as they are.
bool name_matches(const std::string& pattern, const std::string& name);

/// Whether a name is among those that patterns choose: one of them matches it, or there are none,
/// which chooses every name.
bool name_is_chosen(std::span<const std::string> patterns, const std::string& name);

}  // namespace bodyline::model
