#pragma once

#include <span>
#include <string>
#include <vector>

#include "sketch/sketch_model.hpp"
#include "sketch/view_checks.hpp"

namespace bodyline::sketch {

/// Sentences on where the views of a curve disagree: lines that are farther than `tolerance` mm
/// from the fitted curve, ends of the combined views that differ by more than careless drawing does
/// (`length` is that of the combined line, mm), and views that deny what two others tell.
std::vector<std::string> contradictions(const CurveReport& report, double length,
                                        std::span<const ViewCheck> checks, double tolerance);

}  // namespace bodyline::sketch
