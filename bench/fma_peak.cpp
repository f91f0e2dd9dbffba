#include "bench/fma_peak.hpp"

namespace bodyline::bench {
namespace {

constexpr int rounds = 1000;
constexpr int chains =
    12;  // more than latency times throughput of any core so far, and they fit in 16 registers

constexpr int lanes(model::Isa isa) {
  return isa == model::Isa::avx512 ? 8 : isa == model::Isa::avx2 ? 4 : 2;
}

// The compiler's own vectors under a target attribute: one text for all sets.
#define BODYLINE_PEAK(name, width)                                                               \
  double name() {                                                                                \
    typedef double Vector __attribute__((vector_size(width * 8)));                               \
    Vector x[chains];                                                                            \
    for (int i = 0; i < chains; ++i) x[i] = Vector{} + (1.0 + i);                                \
    const Vector factor = Vector{} + 0.999999, term = Vector{} + 1e-3;                           \
    for (int k = 0; k < rounds; ++k) {                                                           \
      _Pragma("GCC unroll 12") for (int i = 0; i < chains; ++i) { x[i] = x[i] * factor + term; } \
    }                                                                                            \
    Vector total = x[0];                                                                         \
    for (int i = 1; i < chains; ++i) total += x[i];                                              \
    return total[0];                                                                             \
  }

BODYLINE_PEAK(peak_baseline, 2)
#if defined(BODYLINE_X86_KERNELS)
__attribute__((target("avx2,fma"))) BODYLINE_PEAK(peak_avx2, 4)
    __attribute__((target("avx512f,fma"))) BODYLINE_PEAK(peak_avx512, 8)
#endif

}  // namespace

double fma_peak_operations(model::Isa isa) { return 2.0 * rounds * chains * lanes(isa); }

double fma_peak(model::Isa isa) {
#if defined(BODYLINE_X86_KERNELS)
  if (isa == model::Isa::avx512) return peak_avx512();
  if (isa == model::Isa::avx2) return peak_avx2();
#endif
  return isa == model::Isa::baseline ? peak_baseline() : 0.0;
}

}  // namespace bodyline::bench
