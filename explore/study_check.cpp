#include "explore/study_check.hpp"

#include "explore/design_space.hpp"
#include "explore/variant_plan.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

void check_study(const Study& study) {
  const DesignSpace space(study);
  check_metrics(study, space);
  make_source(study, space);
}

}  // namespace bodyline::explore
