// Compiled once per instruction set.
#include "model/kernel_lanes.hpp"

namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

void reciprocal_sqrts(const double* x, double* out, int count);

/// count: a multiple of 8.
void reciprocal_sqrts(const double* x, double* out, int count) {
  for (int k = 0; k < count; k += lanes) store(out + k, reciprocal_sqrt(load(x + k)));
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
