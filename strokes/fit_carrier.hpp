#pragma once

#include <vector>

#include "strokes/carrier_equations.hpp"

namespace bodyline::strokes {

struct CarrierOptions {
  double tolerance_mm = 1.0;  ///< largest distance of a sample from the carrier
  bool fair = false;          ///< as fair as the tolerance allows, rather than as close
  int border_order = 1;       ///< 2: tangent planes along the border stay
  /// The base may slide along itself so that places get their points, and gives way to a fairer
  /// surface; else it is left alone where samples do not call for more, and the energy is that of
  /// the displacement.
  bool slides = true;
  int most_cells = 64;  ///< of the grid, per direction
};

/// A carrier, and how it was found.
struct CarrierFit {
  Carrier carrier;
  int cells = 0;
  double fairness = 0.0;      ///< weight of the energy
  double deviation_mm = 0.0;  ///< largest distance of a sample from it
};

/// Finds a surface that passes the samples, wherever over the domain, and is fair where they leave
/// it open; on the border it is the base. First the base is stiffly drawn to the samples over their
/// places, as far as that does not fold it. Then each sample is looked for at its foot, and the
/// grid is made finer until all are within the tolerance.
CarrierFit fit_carrier(const SurfaceFunction& base, const Polygon& domain,
                       std::vector<CarrierSample> samples, const CarrierOptions& options);

}  // namespace bodyline::strokes
