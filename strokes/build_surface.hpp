#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/stroke.hpp"
#include "strokes/surface_model.hpp"

namespace bodyline::strokes {

struct BuildOptions {
  /// Names or patterns of the strokes that make up the boundary. When empty, strokes whose names
  /// begin with "boundary" in upper or lower case are, and where there are none it is found.
  std::vector<std::string> boundary;
  /// Points closer are one, ends closer to a curve are on it, mm; one two-hundredth of the diagonal
  /// of all points when absent.
  std::optional<double> threshold_mm;
  Method method = Method::smooth;
  /// Smooth only: largest distance of the newest strokes from the surface, mm; a fifth of the
  /// threshold when absent.
  std::optional<double> tolerance_mm;
  bool fair = false;  ///< smooth only: as fair as the tolerance allows
};

/// How the boundary was made.
struct BoundaryReport {
  std::vector<std::string> strokes;  ///< in the order of the loop
  bool found = false;                ///< rather than named
  double largest_gap_mm = 0.0;       ///< closed at a corner
  int crossings = 0;                 ///< corners where strokes cross and were trimmed
  int sides = 0;                     ///< after merging
};

/// How a net was made smooth.
struct SmoothReport {
  double tolerance_mm = 0.0;
  int cells = 0;                       ///< of the carrier's grid, per direction
  double fairness = 0.0;               ///< weight of its energy
  double boundary_deviation_mm = 0.0;  ///< of the boundary's strokes from its curves
};

/// A surface made of strokes.
struct SurfaceBuild {
  explicit SurfaceBuild(Net start) : surface(std::move(start)) {}

  SurfaceModel surface;
  BoundaryReport boundary;
  double threshold_mm = 0.0;
  std::optional<SmoothReport> smooth;   ///< of the smooth method
  std::vector<StrokeOutcome> outcomes;  ///< of all strokes inside the boundary, in their order
};

/// Makes the base surface of the strokes of the boundary and inserts the others one after the
/// other. The smooth method then lays the net on a carrier (fit_carrier.hpp). Throws
/// std::invalid_argument when there is no boundary of three or more usable strokes.
SurfaceBuild build_surface(const std::vector<model::Stroke>& strokes,
                           const BuildOptions& options = {});

}  // namespace bodyline::strokes
