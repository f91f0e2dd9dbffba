#include "optimize/fit_target.hpp"

#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

constexpr double heeded_share = 0.9;

}  // namespace

TargetFit target_fit(const std::vector<double>& distances) {
  return {median(distances), trimmed_rms(distances, heeded_share)};
}

}  // namespace bodyline::optimize
