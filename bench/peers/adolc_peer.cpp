#include <adolc/adolc.h>

#include "bench/peers/density.hpp"
#include "bench/peers/generic_vector.hpp"
#include "bench/peers/peers.hpp"

namespace bodyline::bench {
namespace {

constexpr int variables = 48;
constexpr short tape = 1;

adouble energy(const Patch& patch, const adouble* net) {
  adouble total = 0.0;
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      const auto at = [&](int a, int b) {
        return evaluate(net, patch.basis[ku][a], patch.basis[kv][b], Patch::points);
      };
      total += patch.weights[ku] * patch.weights[kv] *
               bending_density<adouble>(at(1, 0), at(0, 1), at(2, 0), at(1, 1), at(0, 2));
    }
  }
  return total;
}

}  // namespace

AdolcBending::AdolcBending(const Patch& patch) {
  trace_on(tape);
  adouble net[variables];
  for (int k = 0; k < variables; ++k) net[k] <<= patch.net[k];
  double value = 0.0;
  energy(patch, net) >>= value;
  trace_off();
}

double AdolcBending::gradient(const Patch& patch, double* gradient) const {
  double value = 0.0, one = 1.0;
  zos_forward(tape, 1, variables, 1, patch.net.data(), &value);
  fos_reverse(tape, 1, variables, &one, gradient);
  return value;
}

}  // namespace bodyline::bench
