#pragma once

#include <stdexcept>
#include <string>

namespace bodyline::strokes {

/// Why a stroke is not made a part of a surface.
enum class Rejection {
  none,
  not_finite,       ///< a coordinate is not a finite number
  too_few_points,   ///< fewer than two points are left after filtering
  closed,           ///< its ends meet
  end_outside,      ///< an end lies beyond the outer boundary
  nothing_left,     ///< trimming at the curves it starts and ends on leaves nothing
  same_side,        ///< both ends on one side of a patch
  along_curve,      ///< its pre-image runs along a curve that is there already
  short_pre_image,  ///< its pre-image is shorter than the domain resolves
  boundary_gap,     ///< it meets the outer boundary in the domain, but not in space
  no_foot_point,    ///< a nearest point on the surface is not found
  too_curved,       ///< its pre-image is too curved to be cut into straight pieces
  sliver            ///< it would cut off a patch that is too thin
};

/// A word with hyphens, such as "end-outside".
std::string rejection_name(Rejection rejection);

/// One clause that says what is wrong, for example "both of its ends are on the same side".
std::string rejection_text(Rejection rejection);

/// Ends the insertion of a stroke from within; does not leave `add_stroke`.
class StrokeRejected : public std::runtime_error {
 public:
  explicit StrokeRejected(Rejection rejection)
      : std::runtime_error(rejection_text(rejection)), rejection_(rejection) {}
  Rejection rejection() const { return rejection_; }

 private:
  Rejection rejection_;
};

}  // namespace bodyline::strokes
