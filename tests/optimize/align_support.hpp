#pragma once

#include <array>
#include <string>

#include "optimize/align_scan.hpp"

/// Scans in any pose and unit, for tests of their alignment.
namespace bodyline::optimize {

inline constexpr int sample_points = 20000;

inline const std::array<double, 5> unit_mm{1.0, 10.0, 25.4, 304.8, 1000.0};
inline const std::array<std::string, 5> unit_names{"mm", "cm", "in", "ft", "m"};

/// A car of the repository.
model::Model car(const std::string& name);

/// A pose with a random rotation and position, in one of the units.
model::Pose drawn_pose(unsigned seed);

/// Why the template is not aligned with a scan; "accepted" when it is.
std::string refusal(const model::Scan& scan, const AlignOptions& options = {});

}  // namespace bodyline::optimize
