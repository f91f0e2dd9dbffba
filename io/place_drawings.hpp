#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/parse_views.hpp"
#include "model/drawing.hpp"

namespace bodyline::io {

/// What a car is drawn like in one view, and what is known of where it lies there.
struct ViewDrawing {
  model::View view = model::View::side;
  model::Drawing drawing;
  Nose nose = Nose::left;
  std::optional<double> scale;            ///< mm of the car per unit; found when not given
  std::optional<Eigen::Vector2d> origin;  ///< what lies at the model's origin, in the drawing's own
                                          ///< coordinates; found when not given
};

/// What is known of the car. Sizes are those of everything drawn, in mm.
struct PlaceOptions {
  std::optional<double> length, width, height;
  Eigen::AlignedBox3d body;  ///< of the model: a drawing without an origin is put to its lower and
                             ///< front end, with the middle of its width at y = 0
};

struct PlacedViews {
  std::vector<model::PlacedDrawing> drawings;  ///< in the order given
  std::vector<Eigen::Affine2d> moves;          ///< from the drawings into the pictures, likewise
  std::vector<double> scales;                  ///< mm per unit, likewise
  Eigen::Vector3d size{0.0, 0.0, 0.0};  ///< length, width and height drawn, mm; 0 where in no view
  std::vector<std::string> notes;       ///< sentences: what was taken for granted, what disagrees
};

/// Nothing says how large the car is in a view.
class NoScale : public std::invalid_argument {
 public:
  NoScale(model::View view, const std::string& sentence)
      : std::invalid_argument(sentence), view_(view) {}
  model::View view() const { return view_; }

 private:
  model::View view_;
};

/// How far two drawings may differ in a size that they share, once their scales are chosen as well
/// as they can be, before they are refused.
inline constexpr double size_tolerance = 0.025;

/// Lays drawings into the views of a model. Views share sizes: side has length and height, top
/// length and width, front and rear width and height; so one scale or one size fixes all that are
/// joined to it, as least squares of the logarithms. Where none is known but a file says how long
/// its unit is on paper and a car so large is possible, the drawing is taken to be at full size.
/// Throws NoScale when a scale cannot be found, and std::invalid_argument when sizes differ
/// by more than `size_tolerance` although a scale could be chosen.
PlacedViews place_drawings(const std::vector<ViewDrawing>& views, const PlaceOptions& options);

}  // namespace bodyline::io
