#pragma once

#include <string>

#include "io/render.hpp"
#include "io/report.hpp"

namespace bodyline::io {

/// The page that write_fair_report writes, with pictures of a given size. The same report gives the
/// same text. Throws as check_body and render do.
std::string fair_report_page(const FairReport& report, const PictureSize& pictures);

}  // namespace bodyline::io
