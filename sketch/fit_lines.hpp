#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sketch/curve_unknowns.hpp"
#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// How well a line is met.
struct LineFit {
  bool drawn_speed = false;  ///< the curve runs along the line as it was drawn
  double rms = 0.0;          ///< distance of the line from the curve between its ends, mm
  double p90 = 0.0;          ///< nine tenths of its points are nearer, mm
};

struct LinesFit {
  Eigen::VectorXd unknowns;    ///< of CurveUnknowns
  std::vector<LineFit> lines;  ///< in the order of the lines
  int rounds = 0;
};

/// What a fit of lines begins with and holds on to where they do not tell.
struct FitLinesStart {
  Eigen::VectorXd unknowns;  ///< near the lines
  /// Control points of all curves that stand for their shape and their speed: the template, scaled.
  std::vector<std::vector<Eigen::Vector3d>> shape;
  std::vector<bool> known;  ///< whether the lines of each curve show all of it, in space
};

/// Moves all curves of a model at once until their projections meet the lines drawn of them, as
/// least squares of distances in the pictures: docs/sketch.md. Curves keep their speed
/// distribution, relative to their length, from the drawing where it tells, otherwise from
/// `start.shape`, as far as the lines leave it open; curves without lines keep their shape between
/// their ends.
LinesFit fit_lines(const model::Model& model, const CurveUnknowns& unknowns,
                   std::span<const SketchLine> lines, const FitLinesStart& start);

}  // namespace bodyline::sketch
