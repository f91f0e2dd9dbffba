#include "model/chain_variable.hpp"

#include <algorithm>
#include <limits>

#include "model/end_constants.hpp"

namespace bodyline::model {
namespace {

constexpr double least_ratio = 0.2, most_ratio = 5.0, most_slide = 10.0;

}  // namespace

std::string index_text(int k) { return "[" + std::to_string(k) + "]"; }

void add_join_variables(const JoinNumbers& join, std::vector<ChainVariable>& variables) {
  variables.push_back({"ratio." + join.name,
                       ChainKind::ratio,
                       {join.ratio_at},
                       std::min(least_ratio, join.ratio),
                       std::max(most_ratio, join.ratio),
                       false});
  if (join.continuity < 2) return;
  variables.push_back({"slide." + join.name,
                       ChainKind::slide,
                       {join.slide_at},
                       std::min(-most_slide, join.slide),
                       std::max(most_slide, join.slide),
                       false});
}

void add_point_variables(const std::string& name, int at, std::vector<ChainVariable>& variables) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    variables.push_back({"point." + name + "." + "xyz" [axis],
                         ChainKind::point,
                         { at + axis },
                         -infinity,
                         infinity,
                         false});
  }
}

bool end_constants_stay(const AnyBasis& basis, std::span<const double> shape, int k, int end,
                        int continuity) {
  const EndConstants slope = end_constants_derivative(basis, shape, end, k);
  return slope.d == 0.0 && (continuity == 1 || (slope.a == 0.0 && slope.b == 0.0));
}

}  // namespace bodyline::model
