#include "explore/variant_status.hpp"

namespace bodyline::explore {

const char* status_name(VariantStatus status) {
  constexpr const char* names[status_count] = {"valid",    "infeasible", "folded",    "cut_order",
                                               "fullness", "lean",       "not_finite"};
  return names[int(status)];
}

}  // namespace bodyline::explore
