#pragma once

#include <string_view>

namespace bodyline::io {

/// The files report.css, report.js and report_viewer.js, put into the program when it is
/// configured.
std::string_view report_style_sheet();
std::string_view report_script();
std::string_view report_viewer_script();

/// For example "0.1.0".
std::string_view program_version();

}  // namespace bodyline::io
