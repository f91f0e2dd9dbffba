#include "optimizer_support.hpp"

namespace bodyline::testing {

std::string text_of(const std::string& optimizer, const std::string& rest,
                    const std::string& variables, const std::string& metrics) {
  return "format = 1\nname = \"test\"\nmodel = \"model1.toml\"\n[variables]\n" + variables +
         "\n[metrics]\n" + metrics + "\n[optimizer]\n" + optimizer + "\n" + rest;
}

}  // namespace bodyline::testing
