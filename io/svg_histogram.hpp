#pragma once

#include <string>
#include <vector>

namespace bodyline::io {

/// Upright bars of how many values fall into equal parts of [-range, range], in the colours of the
/// maps, as an inline SVG that takes the width it is given while its text keeps its size. What lies
/// beyond counts in the outermost bars. Bars say their counts when pointed at. Empty without
/// values.
std::string svg_histogram(const std::vector<double>& values, double range,
                          const std::string& label);

}  // namespace bodyline::io
