#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/palette.hpp"

namespace bodyline::io {

/// A number given in the cells of an even grid over one face; NaN where nothing is known.
struct FaceField {
  std::string name;            ///< of the face; mirror images have the same values
  int cells = 0;               ///< per direction
  std::vector<double> values;  ///< cells x cells, v fastest

  double& at(int i, int j) { return values[i * cells + j]; }
  double at(int i, int j) const { return values[i * cells + j]; }
  /// Linear between the middles of the cells, as far as they are known; NaN in a cell that is
  /// unknown.
  double sample(double u, double v) const;
};

/// A signed number measured over a body, for example the distance of a scan.
struct SurfaceField {
  std::string caption;           ///< for example "distance of the scan, mm"
  double range = 1.0;            ///< where the colours end on both sides
  std::vector<FaceField> faces;  ///< of the left half and the middle; others are unknown
  std::vector<double> values;    ///< all that was measured, for the histogram

  /// Of a face or of its mirror image; null when unknown.
  const FaceField* face(const std::string& name) const;
};

/// Colour of places where a field is unknown.
Color unknown_color();

/// A range for colours: the size that a share of the values stay below, rounded up to 1, 2 or 5
/// times a power of ten; 1 without values that differ from zero.
double symmetric_range(std::vector<double> values, double share = 0.95);

/// How many values fall into each of `bins` equal parts of [-range, range]; values beyond count in
/// the first and the last.
std::vector<std::size_t> histogram(const std::vector<double>& values, double range, int bins);

}  // namespace bodyline::io
