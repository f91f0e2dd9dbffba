#include "bench/body_bench.hpp"
#include "bench/explore_bench.hpp"
#include "bench/fit_bench.hpp"
#include "bench/kernel_bench.hpp"
#include "bench/report.hpp"

int main(int argc, char** argv) {
  using namespace bodyline::bench;
  register_kernel_benchmarks();
  register_body_benchmarks();
  register_fit_benchmarks();
  register_explore_benchmarks();
  return run_and_report(argc, argv,
                        {kernel_report(), body_report(), fit_report(), explore_report()});
}
