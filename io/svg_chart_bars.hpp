#pragma once

#include <string>
#include <vector>

namespace bodyline::io {

/// One row of a chart of changes.
struct ChangeBar {
  std::string name;
  double before = 0.0, after = 0.0;
};

/// Horizontal bars on a logarithmic scale, one per row from the value before to the value after,
/// with a mark at both ends, as an inline SVG that takes the width it is given while its text keeps
/// its size. What is not positive or not finite has no mark. Empty without rows.
std::string svg_change_bars(const std::vector<ChangeBar>& bars, const std::string& title);

}  // namespace bodyline::io
