#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "model/isa_namespace.hpp"

/// Vectors of doubles of the width of one instruction set. Only for sources that are compiled once
/// per instruction set (kernels_impl.cpp): nothing here may leave an object file, hence static and
/// always inlined.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

#define BODYLINE_INLINED __attribute__((always_inline))  // for lambdas
#define BODYLINE_INLINE BODYLINE_INLINED static inline

#if defined(__AVX512F__)
constexpr int lanes = 8;
#elif defined(__AVX2__)
constexpr int lanes = 4;
#else
constexpr int lanes = 2;
#endif

/// One double for each of `lanes` neighbouring Gauss nodes along u; arithmetic is element by
/// element.
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));
using Mask = long long __attribute__((vector_size(lanes * sizeof(double))));

BODYLINE_INLINE Lanes load(const double* p) {
  Lanes x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}

BODYLINE_INLINE void store(double* p, Lanes x) { __builtin_memcpy(p, &x, sizeof x); }

BODYLINE_INLINE Lanes broadcast(double x) { return x - Lanes{}; }

/// Holds a value that is used several times in a register. Otherwise GCC makes its load a part of
/// every use, and 512-bit loads, one a cycle, become the bottleneck. Narrower sets have more loads
/// than registers to spare.
BODYLINE_INLINE Lanes held(Lanes x) {
#if defined(__AVX512F__)
  asm("" : "+v"(x));
#endif
  return x;
}

/// Where the mask is set x, elsewhere zero.
BODYLINE_INLINE Lanes keep_where(Mask mask, Lanes x) { return (Lanes)((Mask)x & mask); }

/// 1 / sqrt(x) for positive normal x, to 2 units in the last place.
BODYLINE_INLINE Lanes reciprocal_sqrt(Lanes x) {
#if defined(__AVX512F__)
  // The estimate y is good to 2^-14. With e = 1 - x y^2 the exact result is y (1 - e)^(-1/2); cut
  // after e^3 the series leaves 35/128 e^4 < 2^-53.
  const Lanes y = _mm512_maskz_rsqrt14_pd(0xff, x);
  const Lanes e = 1.0 - (x * y) * y;
  return y + (y * e) * (0.5 + e * (0.375 + e * 0.3125));
#elif defined(__AVX2__)
  return 1.0 / (Lanes)_mm256_sqrt_pd(x);
#elif defined(__SSE2__)
  return 1.0 / (Lanes)_mm_sqrt_pd(x);
#else
  Lanes root;
  for (int k = 0; k < lanes; ++k) root[k] = __builtin_sqrt(x[k]);
  return 1.0 / root;
#endif
}

/// Sum over the lanes.
BODYLINE_INLINE double sum(Lanes x) {
  double total = 0.0;
  for (int k = 0; k < lanes; ++k) total += x[k];
  return total;
}

/// The sums over the lanes of `lanes` vectors, side by side: a transposition that adds on its way.
BODYLINE_INLINE Lanes sums(const Lanes* x) {
#if defined(__AVX512F__)
  Lanes pair[4], quad[2];
  for (int k = 0; k < 4; ++k) {
    const Lanes a = x[2 * k], b = x[2 * k + 1];
    pair[k] = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
              __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < 2; ++k) {
    const Lanes a = pair[2 * k], b = pair[2 * k + 1];
    quad[k] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13) +
              __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
  }
  return __builtin_shufflevector(quad[0], quad[1], 0, 1, 2, 3, 8, 9, 10, 11) +
         __builtin_shufflevector(quad[0], quad[1], 4, 5, 6, 7, 12, 13, 14, 15);
#elif defined(__AVX2__)
  const Lanes a = __builtin_shufflevector(x[0], x[1], 0, 4, 2, 6) +
                  __builtin_shufflevector(x[0], x[1], 1, 5, 3, 7);
  const Lanes b = __builtin_shufflevector(x[2], x[3], 0, 4, 2, 6) +
                  __builtin_shufflevector(x[2], x[3], 1, 5, 3, 7);
  return __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
#else
  return __builtin_shufflevector(x[0], x[1], 0, 2) + __builtin_shufflevector(x[0], x[1], 1, 3);
#endif
}

/// A point or a direction at `lanes` nodes.
struct Vector {
  Lanes x, y, z;
};

BODYLINE_INLINE Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
BODYLINE_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
BODYLINE_INLINE Vector operator*(Lanes s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
BODYLINE_INLINE Lanes dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
BODYLINE_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
BODYLINE_INLINE Vector load_vector(const Lanes* p) { return {p[0], p[1], p[2]}; }
BODYLINE_INLINE Vector held(const Vector& a) { return {held(a.x), held(a.y), held(a.z)}; }
BODYLINE_INLINE void store_vector(Lanes* p, const Vector& a) {
  p[0] = a.x;
  p[1] = a.y;
  p[2] = a.z;
}
BODYLINE_INLINE Vector broadcast_vector(const double* p) {
  return {broadcast(p[0]), broadcast(p[1]), broadcast(p[2])};
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
