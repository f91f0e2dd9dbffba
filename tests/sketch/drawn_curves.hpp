#pragma once

#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

/// A designer who draws the curves of a body, for tests.
namespace bodyline::testing {

enum class Hand {
  even_parameters,  ///< polylines whose points lie at even parameters of the curve
  even_lengths,     ///< polylines whose points lie at even distances
  bezier            ///< cubic pieces, as an editor holds them
};

struct DrawOptions {
  Hand hand = Hand::even_parameters;
  int points = 100;    ///< of a polyline
  double noise = 0.5;  ///< standard deviation of each coordinate, mm
  double ends = 0.02;  ///< lines end too early or too late by up to this part of the curve
  unsigned seed = 1;
  std::vector<model::View> views = model::all_views();
};

/// The curves of a model in some views. Lines too short to be seen are left out.
std::vector<model::PlacedDrawing> drawn_curves(const model::Model& model,
                                               const DrawOptions& options);

/// The largest distance of a control point of one curve from its place in the other.
double largest_move(const model::Curve& a, const model::Curve& b);

}  // namespace bodyline::testing
