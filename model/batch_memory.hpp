#pragma once

#include "model/corner_net.hpp"
#include "model/packs.hpp"
#include "model/seam.hpp"
#include "model/transition.hpp"

/// What a construction keeps between building and its pullback, batch by batch.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// The arrays of a batch of patches of degrees (m, n).
template <class Real>
struct PatchMemory {
  Vec3<Real>*base, *kept;  ///< nets; `kept` before any seam
  Real *in_u, *in_v;       ///< matrices of the cuts
};

constexpr int patch_memory_numbers(int m, int n) {
  return 6 * (m + 1) * (n + 1) + (m + 1) * (m + 1) + (n + 1) * (n + 1);
}

template <class Real>
struct SeamMemory {
  SeamRows<Real> before;
  SeamTrace<Real> trace;
};

template <class Real>
struct SideMemory {
  TransitionSide<Real> side;
  Vec3<Real> target[2],
      free_edge[2];  ///< uncut sides only; free_edge: next point less the one at the joint
  Real neighbour_width;
  UncutTrace<Real> uncut;
};

template <class Real, int D = 3>
struct CornerMemory {
  TransitionEnd<Real, D> edges[4];
  CornerTrace<Real> trace;
};

/// Memory of a batch that starts at number `at` of a block of bytes.
template <class Memory, class Real>
Memory& memory_at(unsigned char* memory, int at) {
  return *reinterpret_cast<Memory*>(memory + at * sizeof(typename Pack<Real>::Number));
}

template <class Real>
PatchMemory<Real> patch_memory_at(unsigned char* memory, int at, int m, int n) {
  Real* first = reinterpret_cast<Real*>(memory + at * sizeof(typename Pack<Real>::Number));
  const int points = (m + 1) * (n + 1);
  Real* in_u = first + 6 * points;
  return {reinterpret_cast<Vec3<Real>*>(first), reinterpret_cast<Vec3<Real>*>(first) + points, in_u,
          in_u + (m + 1) * (m + 1)};
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
