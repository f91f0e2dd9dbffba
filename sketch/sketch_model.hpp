#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

namespace bodyline::sketch {

struct SketchOptions {
  double tolerance = 10.0;  ///< a drawn line of which a tenth is farther from its curve is a
                            ///< contradiction, and so is a place that two views tell and a
                            ///< third one denies, mm
  std::map<std::string, double> tolerances;  ///< of curves by name, where they differ, mm

  double tolerance_of(const std::string& curve) const {
    const auto own = tolerances.find(curve);
    return own == tolerances.end() ? tolerance : own->second;
  }
};

/// One drawing of a curve.
struct CurveView {
  model::View view = model::View::side;
  bool drawn_speed = false;  ///< the curve runs along the line as it was drawn
  double rms = 0.0;          ///< distance of the line from the curve, mm
  double p90 = 0.0;          ///< nine tenths of its points are nearer, mm
};

/// Where the shape of a curve comes from.
enum class CurveSource {
  drawn,       ///< two views or more
  half_drawn,  ///< one view, or views that share no axis along which it advances: what they do not
               ///< show is the template's
  missing      ///< no view: the template's, brought to the size and the vertices of what is drawn
};

struct CurveReport {
  std::string curve;
  CurveSource source = CurveSource::missing;
  std::vector<CurveView> views;
  /// Of a drawn curve: the views that were combined, the axis that they share, 'x', 'y' or 'z', the
  /// range of both drawings along it (eq. 16), and how far their ends differ in it at most, mm.
  std::array<model::View, 2> combined{};
  char axis = ' ';
  std::array<double, 2> range{};
  double apart = 0.0;
  std::vector<std::string> contradictions;  ///< sentences: where views disagree
};

struct SketchResult {
  model::Model model;
  std::vector<CurveReport> curves;   ///< in the order of the model
  std::vector<std::string> unknown;  ///< names in the drawings that are no curve's
  int rounds = 0;                    ///< of the fit
};

/// Builds a body from drawings of its curves in several views (docs/sketch.md; Liu et al. 2020,
/// section 4.1). `start` gives the names and degrees of the curves, everything besides curves, and
/// the curves that are not drawn. All curves are fitted at once, so those that meet do so exactly,
/// and mirror symmetry holds exactly. Throws std::invalid_argument when no curve is drawn, and
/// ModelError when `start` is not connected.
SketchResult sketch_model(const model::Model& start, std::span<const model::PlacedDrawing> drawings,
                          const SketchOptions& options = {});

}  // namespace bodyline::sketch
