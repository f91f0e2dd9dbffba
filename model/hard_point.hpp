#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

namespace bodyline::model {

/// What a body must do with a point.
enum class HardPointRule {
  through,  ///< have it on its surface
  inside,   ///< contain it
  outside   ///< keep clear of it
};

/// "through", "inside" or "outside".
std::string rule_name(HardPointRule rule);
/// Nothing where there is no rule of this name.
std::optional<HardPointRule> rule_from_name(std::string_view name);

/// A point that a body must heed, in its coordinates, mm. On which side of the body it lies is told
/// by the nearest point of the surface.
struct HardPoint {
  Eigen::Vector3d point;
  HardPointRule rule = HardPointRule::through;
  double margin = 0.0;  ///< least distance from the surface when inside or outside, mm
};

/// How far a point that lies at a signed distance from a body, outside positive, is from keeping
/// its rule, mm; 0 when it does.
double breach(const HardPoint& point, double distance);

}  // namespace bodyline::model
