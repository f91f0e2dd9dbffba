#pragma once

#include <string_view>

namespace bodyline::io {

/// The files report.css and report.js, put into the program when it is configured.
std::string_view report_style_sheet();
std::string_view report_script();

/// For example "0.1.0".
std::string_view program_version();

}  // namespace bodyline::io
