#pragma once

#include "model/isa_namespace.hpp"

/// Loops that the compiler sees as a sequence of statements, so that small arrays live in
/// registers.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// A number that the compiler knows.
template <int N>
struct Index {
  constexpr operator int() const { return N; }
};

/// body(Index<First>), ..., body(Index<Last>); nothing when Last < First.
template <int First, int Last, class Body>
__attribute__((always_inline)) inline void unrolled(const Body& body) {
  if constexpr (First <= Last) {
    body(Index<First>{});
    unrolled<First + 1, Last>(body);
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
