#pragma once

#include <string_view>

/// The scripts of the pages that the program writes, bundled when it is built. None holds what
/// would end a <script> or <style> element.
namespace bodyline::web {

/// Of the page that `browse` writes.
std::string_view browse_script();
std::string_view browse_style_sheet();

/// Of the view in three dimensions in the reports of `fair` and `fit`.
std::string_view report_viewer_script();

}  // namespace bodyline::web
