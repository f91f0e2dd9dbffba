#include "strokes/fit_carrier.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "strokes/points.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Samples = std::vector<CarrierSample>;

constexpr int first_cells = 8;
// Of the displacement of a base that is kept: coarser grids swing far away from the samples for a
// hair's breadth at them.
constexpr int first_cells_of_kept = 32;
constexpr int most_rounds = 3;  // of looking for feet, per grid
// Weights of the energy. The first decides only what samples leave open: it takes less than a
// thousandth from waves of an eighth of the domain.
constexpr double least_fairness = 1e-9, most_fairness = 1.0;
constexpr double stiffness[] = {1e-5, 1e-4, 1e-3};
constexpr int fairness_halvings = 7;
// A base that is drawn to the samples keeps this part of its area everywhere, and its side.
constexpr double kept_area = 0.3;
constexpr int lattice = 24;

Carrier undisplaced(const SurfaceFunction& base, const CarrierBasis& basis) {
  return {base, basis, Eigen::MatrixX3d::Zero(basis.count(), 3)};
}

bool keeps_shape(const SurfaceFunction& base, const Carrier& carrier) {
  for (int i = 0; i < lattice; ++i) {
    for (int j = 0; j < lattice; ++j) {
      const Vector2d place((i + 0.5) / lattice, (j + 0.5) / lattice);
      if (depth(carrier.basis().domain, place) < 0.0) continue;
      const PatchJet before = base(place), after = carrier.jet(place);
      const Vector3d normal = before.s.cross(before.t);
      if (!(normal.dot(after.s.cross(after.t)) > kept_area * normal.squaredNorm())) return false;
    }
  }
  return true;
}

/// The base drawn to the samples over their places, least stiffly without folds.
Carrier drawn_base(const SurfaceFunction& base, const CarrierBasis& basis, const Samples& samples) {
  CarrierEquations equations(base, basis);
  equations.set_samples(samples);
  for (const double fairness : stiffness) {
    auto carrier = equations.solve(fairness);
    if (carrier && keeps_shape(base, *carrier)) return *carrier;
  }
  return undisplaced(base, basis);
}

double deviation(const Carrier& carrier, const Samples& samples) {
  double largest = 0.0;
  for (const CarrierSample& sample : samples)
    largest = larger((carrier.jet(sample.place).point - sample.point).norm(), largest);
  return largest;
}

void find_feet(const Carrier& carrier, Samples& samples) {
  for (CarrierSample& sample : samples)
    sample.place = carrier_foot(carrier, sample.place, sample.point);
}

/// A search for the carrier on one grid.
class GridSearch {
 public:
  GridSearch(const SurfaceFunction& base, const CarrierBasis& basis, const CarrierOptions& options)
      : equations_(base, basis, options.slides ? Fair::surface : Fair::displacement),
        tolerance_mm_(options.tolerance_mm) {}

  /// Solves and looks for feet in turns; leaves the samples at the feet.
  std::optional<CarrierFit> closest(Samples& samples, double fairness) {
    std::optional<CarrierFit> best;
    for (int round = 0; round < most_rounds; ++round) {
      equations_.set_samples(samples);
      const auto carrier = equations_.solve(fairness);
      if (!carrier) break;
      find_feet(*carrier, samples);
      const double away = deviation(*carrier, samples);
      if (!std::isfinite(away) || (best && !(away < best->deviation_mm))) break;
      best = CarrierFit{*carrier, carrier->basis().cells, fairness, away};
      if (away <= tolerance_mm_) break;
    }
    return best;
  }

  /// The largest weight of the energy, by halvings of its logarithm, that keeps to the tolerance.
  CarrierFit fairest(const Samples& samples, CarrierFit fit) {
    double low = std::log(fit.fairness), high = std::log(most_fairness);
    for (int k = 0; k < fairness_halvings; ++k) {
      const double middle = 0.5 * (low + high);
      Samples moved = samples;
      auto fairer = closest(moved, std::exp(middle));
      if (fairer && fairer->deviation_mm <= tolerance_mm_) {
        low = middle;
        fit = *fairer;
      } else {
        high = middle;
      }
    }
    return fit;
  }

 private:
  CarrierEquations equations_;
  double tolerance_mm_;
};

}  // namespace

CarrierFit fit_carrier(const SurfaceFunction& base, const Polygon& domain, Samples samples,
                       const CarrierOptions& options) {
  const CarrierBasis coarse{domain, options.border_order, first_cells};
  const Carrier start =
      options.slides ? drawn_base(base, coarse, samples) : undisplaced(base, coarse);
  const SurfaceFunction drawn = [start](const Vector2d& place) { return start.jet(place); };
  find_feet(start, samples);
  CarrierFit best{start, first_cells, 0.0, deviation(start, samples)};
  if (!options.slides && best.deviation_mm <= options.tolerance_mm) return best;
  const int first = options.slides ? first_cells : first_cells_of_kept;
  for (int cells = std::min(first, options.most_cells); cells <= options.most_cells; cells *= 2) {
    GridSearch search(drawn, {domain, options.border_order, cells}, options);
    Samples moved = samples;
    const auto fit = search.closest(moved, least_fairness);
    if (!fit) continue;
    if (fit->deviation_mm < best.deviation_mm || best.fairness == 0.0) best = *fit;
    if (best.deviation_mm > options.tolerance_mm) continue;
    return options.fair ? search.fairest(moved, best) : best;
  }
  return best;
}

}  // namespace bodyline::strokes
