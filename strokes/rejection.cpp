#include "strokes/rejection.hpp"

namespace bodyline::strokes {
namespace {

struct Words {
  const char* name;
  const char* text;
};

Words words(Rejection rejection) {
  switch (rejection) {
    case Rejection::none:
      return {"none", "nothing is wrong with it"};
    case Rejection::not_finite:
      return {"not-finite", "a coordinate is not a finite number"};
    case Rejection::too_few_points:
      return {"too-few-points", "fewer than two distinct points are left after filtering"};
    case Rejection::closed:
      return {"closed", "it is closed: draw it as two or more open strokes"};
    case Rejection::end_outside:
      return {"end-outside", "an end lies outside the boundary"};
    case Rejection::nothing_left:
      return {"nothing-left", "nothing is left of it between the curves that it touches"};
    case Rejection::same_side:
      return {"same-side", "it leaves a patch through the side by which it came"};
    case Rejection::along_curve:
      return {"along-curve", "it runs along a curve that is there already"};
    case Rejection::short_pre_image:
      return {"short-pre-image", "it is too short"};
    case Rejection::boundary_gap:
      return {"boundary-gap", "it ends above or below the boundary without touching it"};
    case Rejection::no_foot_point:
      return {"no-foot-point", "a nearest point on the surface is not found"};
    case Rejection::too_curved:
      return {"too-curved", "it turns too much to be cut into straight pieces"};
    case Rejection::sliver:
      return {"sliver", "it would cut off a sliver"};
  }
  return {"", ""};
}

}  // namespace

std::string rejection_name(Rejection rejection) { return words(rejection).name; }

std::string rejection_text(Rejection rejection) { return words(rejection).text; }

}  // namespace bodyline::strokes
