#include <unistd.h>

#include <iostream>

#include "cli/program.hpp"

int main(int argc, char** argv) {
  bodyline::cli::Context context;
  context.out = &std::cout;
  context.err = &std::cerr;
  context.terminal = ::isatty(STDERR_FILENO) == 1;
  return bodyline::cli::run_program(argc, argv, context);
}
