#pragma once

#include <vector>

#include "strokes/carrier.hpp"
#include "strokes/net.hpp"

namespace bodyline::strokes {

/// The curves around a domain, side by side, over [0, 1] each.
struct Border {
  std::vector<model::SplineCurve> curves;
  /// Derivatives across them by the side of the domain turned left by a right angle; where none are
  /// given they are those of the carrier.
  std::vector<model::SplineCurve> across = {};
};

/// The net with its patches on a carrier: edges keep their pre-images and follow the carrier within
/// `tolerance_mm`, those of the border are parts of its curves, and all patches that meet in an
/// edge have one tangent plane along it. Nothing moves in the domain.
Net smooth_net(Net net, const Carrier& carrier, const Border& border, double tolerance_mm);

}  // namespace bodyline::strokes
