#include "optimize/fit_options.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace bodyline::optimize {
namespace {

using Number = std::pair<const char*, double>;

void refuse(const char* name, const char* what) {
  throw std::invalid_argument(std::string("the option ") + name + " of a fit " + what);
}

}  // namespace

void check_fit_options(const FitOptions& options) {
  if (options.starts.empty()) refuse("starts", "must not be empty");
  for (const FitStart& start : options.starts) {
    if (!start.move.allFinite() || !std::isfinite(start.estate))
      refuse("starts", "must hold finite numbers");
  }
  for (const auto& [name, count] : {std::pair{"warp_rounds", options.warp_rounds},
                                    {"curve_rounds", options.curve_rounds},
                                    {"body_rounds", options.body_rounds},
                                    {"unfold_rounds", options.unfold_rounds}}) {
    if (count < 0) refuse(name, "must not be negative");
  }
  for (const auto& [name, distance] : {Number{"far", options.far}, Number{"near", options.near},
                                       Number{"rim_near", options.rim_near}}) {
    if (!(distance > 0.0) || !std::isfinite(distance)) refuse(name, "must be positive and finite");
  }
  if (options.near > options.far) refuse("near", "must not be greater than far");
  for (const auto& [name, weight] :
       {Number{"bending", options.bending}, Number{"fold", options.fold},
        Number{"stay", options.stay}, Number{"rims", options.rims},
        Number{"edges", options.edges}}) {
    if (!(weight >= 0.0) || !std::isfinite(weight)) refuse(name, "must be finite and not negative");
  }
}

}  // namespace bodyline::optimize
