#pragma once

#include <string_view>

namespace bodyline::cli {

/// The body template, cars/template.toml, as the program carries it.
std::string_view template_text();

}  // namespace bodyline::cli
