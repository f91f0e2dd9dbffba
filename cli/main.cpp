#include <unistd.h>

#include <iostream>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "cli/program.hpp"

namespace {

// `explore` frees and allocates blocks of a megabyte all the time; to give their pages back and to
// fetch them again would cost it 5 % of its time.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
  mallopt(M_TRIM_THRESHOLD, 128 * megabyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  bodyline::cli::Context context;
  context.out = &std::cout;
  context.err = &std::cerr;
  context.terminal = ::isatty(STDERR_FILENO) == 1;
  return bodyline::cli::run_program(argc, argv, context);
}
