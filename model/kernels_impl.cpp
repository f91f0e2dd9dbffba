// Compiled once per instruction set, with BODYLINE_ISA_NAMESPACE naming the set. No function of
// another header may be inlined here: the linker could keep this copy of it, and then code for
// AVX-512 would run on a machine without.

#include "model/kernel_area.hpp"
#include "model/kernel_bending.hpp"
#include "model/kernel_fold.hpp"
#include "model/kernel_foot_point.hpp"
#include "model/kernel_integral.hpp"
#include "model/kernel_moments.hpp"
#include "model/kernel_pull.hpp"
#include "model/kernel_samples.hpp"
#include "model/kernel_tables.hpp"
#include "model/kernel_variation.hpp"

#define BODYLINE_TEXT_(name) #name
#define BODYLINE_TEXT(name) BODYLINE_TEXT_(name)

namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

const Kernels& table() {
  static constexpr Kernels kernels = {
      .name = BODYLINE_TEXT(BODYLINE_ISA_NAMESPACE),
      .area = integral<Area>,
      .bending = integral<Bending>,
      .variation = integral<Variation>,
      .area_pullback = integral_pullback<Area>,
      .bending_pullback = integral_pullback<Bending>,
      .variation_pullback = integral_pullback<Variation>,
      .fold = fold,
      .fold_pullback = fold_pullback,
      .jets = jets,
      .curvature = curvature,
      .foot_points = foot_points,
      .pulls = pulls,
      .add_moments = add_moments,
  };
  return kernels;
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
