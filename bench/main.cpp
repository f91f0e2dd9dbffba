#include <cstdlib>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "bench/body_bench.hpp"
#include "bench/explore_bench.hpp"
#include "bench/fit_bench.hpp"
#include "bench/kernel_bench.hpp"
#include "bench/report.hpp"
#include "bench/strokes_bench.hpp"

// As the program does it (cli/main.cpp).
static void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
  mallopt(M_TRIM_THRESHOLD, 128 * megabyte);
#endif
}

int main(int argc, char** argv) {
  using namespace bodyline::bench;
  keep_freed_memory();
  register_kernel_benchmarks();
  register_body_benchmarks();
  register_fit_benchmarks();
  register_explore_benchmarks();
  register_strokes_benchmarks();
  return run_and_report(
      argc, argv,
      {kernel_report(), body_report(), fit_report(), explore_report(), strokes_report()});
}
