#pragma once

#include <string>

#include "io/report.hpp"

/// A small tuning run and its page, for the tests of the report.
namespace bodyline::tests {

/// model1 of the cars against itself with a few moved values: every kind of variable, a term and a
/// step.
io::FairReport small_report();

/// Its page, with small pictures, which take less time.
std::string page_of(const io::FairReport& report);

/// A sentence that says which tag is not closed or closed too often; empty for a well-formed page.
/// Scripts and style sheets are passed over, as a browser does.
std::string tag_error(const std::string& page);

/// The page without its embedded data, scripts, styles and markup: what a reader sees, and the
/// titles.
std::string visible_text(const std::string& page);

/// The page without the name of the namespace of HTML, which looks like an address but is none.
std::string without_namespaces(std::string page);

}  // namespace bodyline::tests
