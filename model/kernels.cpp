#include "model/kernels.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "model/kernel_tables.hpp"

namespace bodyline::model {
namespace {

constexpr Isa all_sets[] = {Isa::avx512, Isa::avx2, Isa::baseline};  // best first

const char* isa_name(Isa isa) {
  switch (isa) {
    case Isa::baseline:
      return "baseline";
    case Isa::avx2:
      return "avx2";
    case Isa::avx512:
      return "avx512";
  }
  return "";
}

bool processor_has(Isa isa) {
  if (isa == Isa::baseline) return true;
#if defined(BODYLINE_X86_KERNELS)
  if (isa == Isa::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

}  // namespace

bool isa_available(Isa isa) { return processor_has(isa); }

Isa best_isa() {
  // A name that this machine cannot serve, or no name at all, leaves the choice to us.
  const char* wanted = std::getenv("BODYLINE_ISA");
  for (const Isa isa : all_sets) {
    if (wanted != nullptr && std::string(wanted) == isa_name(isa) && isa_available(isa)) return isa;
  }
  for (const Isa isa : all_sets) {
    if (isa_available(isa)) return isa;
  }
  return Isa::baseline;
}

const Kernels& kernels(Isa isa) {
  if (!isa_available(isa)) {
    throw std::invalid_argument(std::string("this processor or build has no kernels for ") +
                                isa_name(isa));
  }
#if defined(BODYLINE_X86_KERNELS)
  if (isa == Isa::avx512) return isa::avx512::table();
  if (isa == Isa::avx2) return isa::avx2::table();
#endif
  return isa::baseline::table();
}

}  // namespace bodyline::model
