#pragma once

#include "model/kernel_lanes.hpp"

/// Between points that lie anywhere in memory and vectors of one coordinate of several points.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

template <int Count>
struct LaneVectorOf {
  using Type __attribute__((vector_size(Count * sizeof(double)))) = double;
};
template <int Count>
using LaneVector = typename LaneVectorOf<Count>::Type;

using Pair = LaneVector<2>;
using Quad = LaneVector<4>;
#if defined(__AVX512F__)
using Octet = LaneVector<8>;
#endif

BODYLINE_INLINE Pair lane_sqrt(Pair x) {
#if defined(__SSE2__)
  return (Pair)_mm_sqrt_pd(x);
#else
  return Pair{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
#endif
}

/// Rows and columns of a square block of numbers exchanged.
BODYLINE_INLINE void transpose_block(Pair* x) {
  const Pair low = __builtin_shufflevector(x[0], x[1], 0, 2);
  x[1] = __builtin_shufflevector(x[0], x[1], 1, 3);
  x[0] = low;
}

#if defined(__AVX2__)
BODYLINE_INLINE Quad lane_sqrt(Quad x) { return (Quad)_mm256_sqrt_pd(x); }

BODYLINE_INLINE Quad load_quad(const double* p) {
  Quad x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}

BODYLINE_INLINE void transpose_block(Quad* x) {
  const Quad a = __builtin_shufflevector(x[0], x[1], 0, 4, 2, 6),
             b = __builtin_shufflevector(x[0], x[1], 1, 5, 3, 7);
  const Quad c = __builtin_shufflevector(x[2], x[3], 0, 4, 2, 6),
             d = __builtin_shufflevector(x[2], x[3], 1, 5, 3, 7);
  x[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  x[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  x[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  x[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

/// x, y, z of the points at p + at[lane]; reads one number past each.
BODYLINE_INLINE void gather_points(const double* p, const int* at, Quad* xyz) {
  Quad block[4] = {load_quad(p + at[0]), load_quad(p + at[1]), load_quad(p + at[2]),
                   load_quad(p + at[3])};
  transpose_block(block);
  xyz[0] = block[0];
  xyz[1] = block[1];
  xyz[2] = block[2];
}
#endif

#if defined(__AVX512F__)
BODYLINE_INLINE Octet lane_sqrt(Octet x) { return (Octet)_mm512_maskz_sqrt_pd(0xff, x); }

BODYLINE_INLINE void transpose_block(Octet* x) {
  Octet pair[8], quad[8];
#pragma GCC unroll 4
  for (int k = 0; k < 8; k += 2) {
    pair[k] = __builtin_shufflevector(x[k], x[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pair[k + 1] = __builtin_shufflevector(x[k], x[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    const int at = k < 2 ? k : k + 2;
    quad[at] = __builtin_shufflevector(pair[at], pair[at + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    quad[at + 2] = __builtin_shufflevector(pair[at], pair[at + 2], 2, 3, 10, 11, 6, 7, 14, 15);
  }
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    x[k] = __builtin_shufflevector(quad[k], quad[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    x[k + 4] = __builtin_shufflevector(quad[k], quad[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

// Two blocks of four numbers side by side.
BODYLINE_INLINE Octet join(const double* low, const double* high) {
  return __builtin_shufflevector(load_quad(low), load_quad(high), 0, 1, 2, 3, 4, 5, 6, 7);
}

BODYLINE_INLINE void gather_points(const double* p, const int* at, Octet* xyz) {
  const Octet a = join(p + at[0], p + at[4]), b = join(p + at[1], p + at[5]);
  const Octet c = join(p + at[2], p + at[6]), d = join(p + at[3], p + at[7]);
  const Octet ab_xz = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Octet cd_xz = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Octet ab_y = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Octet cd_y = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  xyz[0] = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 8, 9, 4, 5, 12, 13);
  xyz[1] = __builtin_shufflevector(ab_y, cd_y, 0, 1, 8, 9, 4, 5, 12, 13);
  xyz[2] = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Points of eight lanes as x, y, z and a fourth number, those of lanes l and l + 4 side by side in
/// [l].
struct PointPairs {
  Octet of[4];
};
BODYLINE_INLINE PointPairs transpose_points(Octet x, Octet y, Octet z) {
  const Octet even = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Octet odd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
  return {{__builtin_shufflevector(even, z, 0, 1, 8, 8, 4, 5, 12, 12),
           __builtin_shufflevector(odd, z, 0, 1, 9, 9, 4, 5, 13, 13),
           __builtin_shufflevector(even, z, 2, 3, 10, 10, 6, 7, 14, 14),
           __builtin_shufflevector(odd, z, 2, 3, 11, 11, 6, 7, 15, 15)}};
}
#endif

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
