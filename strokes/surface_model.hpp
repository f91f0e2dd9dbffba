#pragma once

#include <string>
#include <vector>

#include "model/stroke.hpp"
#include "strokes/insert_line.hpp"
#include "strokes/net.hpp"
#include "strokes/rejection.hpp"
#include "strokes/surface_index.hpp"

namespace bodyline::strokes {

/// How strokes make a surface.
enum class Method {
  smooth,  ///< strokes are fitted within a tolerance, patches join with one tangent plane
  paper    ///< strokes are polylines, patches meet in creases
};

/// Lengths of the domain and in space by which strokes are judged.
struct StrokeOptions {
  double threshold_mm = 0.0;         ///< points closer are one; ends closer to a curve are on it
  double straightness = 0.02;        ///< farthest a pre-image may lie from its line, of the domain
  double loose_straightness = 0.15;  ///< the same for strokes that begin and end on curves
  Method method = Method::paper;
  double tolerance_mm = 0.0;  ///< smooth only: largest distance of a stroke from its curve
};

/// What became of a stroke.
struct StrokeOutcome {
  std::string name;
  int number = -1;  ///< of its edges, and in moves
  Rejection rejection = Rejection::none;
  int lines = 0;  ///< straight pieces of its pre-image
  int patches_split = 0;
  int curves_moved = 0;  ///< earlier curves and vertices that gave way to it
  double largest_move_mm = 0.0;
  int ends_extended = 0;               ///< ends, of all pieces, that lay inside a patch
  int points_trimmed = 0;              ///< beyond the curves it begins and ends on
  double end_move_mm = 0.0;            ///< farthest that an end was moved onto one of them
  std::vector<Eigen::Vector3d> drawn;  ///< what of it is left, as it was inserted; mm
  std::vector<Eigen::Vector3d> asked;  ///< its points as they were read, between those curves; mm
  std::vector<StrokeMove> moves;       ///< of what was drawn of earlier strokes
  double gave_way_mm = 0.0;            ///< to later strokes
  double deviation_mm = 0.0;           ///< largest distance of `asked` from the finished surface
  double newest_deviation_mm = 0.0;    ///< the same where it did not give way to a later stroke
};

/// A surface that grows stroke by stroke.
struct SurfaceModel {
  Net net;
  SurfaceIndex index;

  explicit SurfaceModel(Net start) : net(std::move(start)), index(net) {}
};

}  // namespace bodyline::strokes
