#pragma once

#include "model/kernel_lanes.hpp"
#include "model/packs.hpp"

/// A number of several lanes: one double of each of `lanes` steps of the same kind, so that the
/// templates of the stages build several faces at once. Only for sources that are compiled once per
/// instruction set.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

struct Lane {
  Lanes v;

  Lane() = default;
  BODYLINE_INLINED explicit Lane(double x) : v(broadcast(x)) {}
  BODYLINE_INLINED explicit Lane(Lanes x) : v(x) {}

  BODYLINE_INLINED Lane& operator+=(Lane b) { return v += b.v, *this; }
  BODYLINE_INLINED Lane& operator-=(Lane b) { return v -= b.v, *this; }
};

BODYLINE_INLINE Lane operator+(Lane a, Lane b) { return Lane(a.v + b.v); }
BODYLINE_INLINE Lane operator-(Lane a, Lane b) { return Lane(a.v - b.v); }
BODYLINE_INLINE Lane operator-(Lane a) { return Lane(-a.v); }
BODYLINE_INLINE Lane operator*(Lane a, Lane b) { return Lane(a.v * b.v); }
BODYLINE_INLINE Lane operator/(Lane a, Lane b) { return Lane(a.v / b.v); }

BODYLINE_INLINE Lane sqrt(Lane a) {
#if defined(__AVX512F__)
  return Lane((Lanes)_mm512_maskz_sqrt_pd(0xff, a.v));
#elif defined(__AVX2__)
  return Lane((Lanes)_mm256_sqrt_pd(a.v));
#else
  for (int l = 0; l < lanes; ++l) a.v[l] = __builtin_sqrt(a.v[l]);
  return a;
#endif
}

BODYLINE_INLINE Lane where_at_least(const Lane& x, const Lane& floor, const Lane& yes,
                                    const Lane& no) {
  return Lane(x.v >= floor.v ? yes.v : no.v);
}

#if defined(__AVX512F__)
using Quad = double __attribute__((vector_size(32)));

// Two blocks of four numbers side by side.
BODYLINE_INLINE Lanes join(const double* low, const double* high) {
  Quad a, b;
  __builtin_memcpy(&a, low, sizeof a);
  __builtin_memcpy(&b, high, sizeof b);
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Points of eight lanes as x, y, z and a fourth number, those of lanes l and l + 4 side by side in
/// [l].
struct Transposed {
  Lanes of[4];
};
BODYLINE_INLINE Transposed transpose(Lanes x, Lanes y, Lanes z) {
  const Lanes even = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes odd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
  return {{__builtin_shufflevector(even, z, 0, 1, 8, 8, 4, 5, 12, 12),
           __builtin_shufflevector(odd, z, 0, 1, 9, 9, 4, 5, 13, 13),
           __builtin_shufflevector(even, z, 2, 3, 10, 10, 6, 7, 14, 14),
           __builtin_shufflevector(odd, z, 2, 3, 11, 11, 6, 7, 15, 15)}};
}
#endif

using Pair = double __attribute__((vector_size(16)));

/// Rows and columns of a block of lanes x lanes numbers exchanged.
BODYLINE_INLINE void transpose_block(Lanes* x) {
#if defined(__AVX512F__)
  Lanes pair[8], quad[8];
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
#elif defined(__AVX2__)
  Lanes pair[4];
#pragma GCC unroll 2
  for (int k = 0; k < 4; k += 2) {
    pair[k] = __builtin_shufflevector(x[k], x[k + 1], 0, 4, 2, 6);
    pair[k + 1] = __builtin_shufflevector(x[k], x[k + 1], 1, 5, 3, 7);
  }
#pragma GCC unroll 2
  for (int k = 0; k < 2; ++k) {
    x[k] = __builtin_shufflevector(pair[k], pair[k + 2], 0, 1, 4, 5);
    x[k + 2] = __builtin_shufflevector(pair[k], pair[k + 2], 2, 3, 6, 7);
  }
#else
  const Lanes low = __builtin_shufflevector(x[0], x[1], 0, 2);
  x[1] = __builtin_shufflevector(x[0], x[1], 1, 3);
  x[0] = low;
#endif
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE

namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <>
struct Pack<isa::BODYLINE_ISA_NAMESPACE::Lane> {
  using Number = double;
  using Lane = isa::BODYLINE_ISA_NAMESPACE::Lane;
  using Lanes = isa::BODYLINE_ISA_NAMESPACE::Lanes;
  static constexpr int lanes = isa::BODYLINE_ISA_NAMESPACE::lanes;

  BODYLINE_INLINED static Lane read(const double* array, const int* at, int shift) {
    const double* p = array + shift;
#if defined(__AVX512F__)
    return Lane(
        Lanes{p[at[0]], p[at[1]], p[at[2]], p[at[3]], p[at[4]], p[at[5]], p[at[6]], p[at[7]]});
#elif defined(__AVX2__)
    return Lane(Lanes{p[at[0]], p[at[1]], p[at[2]], p[at[3]]});
#else
    return Lane(Lanes{p[at[0]], p[at[1]]});
#endif
  }

  BODYLINE_INLINED static void add(double* array, const int* at, int shift, int count,
                                   const Lane& value) {
#pragma GCC unroll 8
    for (int l = 0; l < lanes; ++l) {
      if (l >= count) return;
      array[at[l] + shift] += value.v[l];
    }
  }

  BODYLINE_INLINED static Lane numbers(const double* of_lane) {
    return Lane(isa::BODYLINE_ISA_NAMESPACE::load(of_lane));
  }

  /// Reads one number past the point.
  BODYLINE_INLINED static Vec3<Lane> read_point(const double* array, const int* at, int shift) {
    const double* p = array + shift;
#if defined(__AVX512F__)
    using isa::BODYLINE_ISA_NAMESPACE::join;
    const Lanes a = join(p + at[0], p + at[4]), b = join(p + at[1], p + at[5]);
    const Lanes c = join(p + at[2], p + at[6]), d = join(p + at[3], p + at[7]);
    const Lanes ab_xz = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const Lanes cd_xz = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const Lanes ab_y = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const Lanes cd_y = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    return {Lane(__builtin_shufflevector(ab_xz, cd_xz, 0, 1, 8, 9, 4, 5, 12, 13)),
            Lane(__builtin_shufflevector(ab_y, cd_y, 0, 1, 8, 9, 4, 5, 12, 13)),
            Lane(__builtin_shufflevector(ab_xz, cd_xz, 2, 3, 10, 11, 6, 7, 14, 15))};
#else
    return {read(p, at, 0), read(p, at, 1), read(p, at, 2)};
#endif
  }

  /// Lanes that repeat a step write the same point again.
  BODYLINE_INLINED static void write_point(double* array, const int* at, int shift,
                                           const Vec3<Lane>& value) {
    each_point(value, lanes, [&](int l, Pair xy, double z) BODYLINE_INLINED {
      double* p = array + at[l] + shift;
      __builtin_memcpy(p, &xy, sizeof xy);
      p[2] = z;
    });
  }

  BODYLINE_INLINED static void read_net(const double* array, const int* at, int points,
                                        Vec3<Lane>* net) {
    Lane* out = &net->x;
    const int blocks = 3 * points / lanes;
    for (int b = 0; b < blocks; ++b) {
      const int first = b * lanes;
      Lanes block[lanes];
#pragma GCC unroll 8
      for (int l = 0; l < lanes; ++l)
        block[l] = isa::BODYLINE_ISA_NAMESPACE::load(array + at[l] + first);
      isa::BODYLINE_ISA_NAMESPACE::transpose_block(block);
#pragma GCC unroll 8
      for (int k = 0; k < lanes; ++k) out[first + k] = Lane(block[k]);
    }
    for (int k = blocks * lanes; k < 3 * points; ++k) out[k] = read(array, at, k);
  }

  BODYLINE_INLINED static void write_net(double* array, const int* at, int points,
                                         const Vec3<Lane>* net) {
    const Lane* in = &net->x;
    const int blocks = 3 * points / lanes;
    for (int b = 0; b < blocks; ++b) {
      const int first = b * lanes;
      Lanes block[lanes];
#pragma GCC unroll 8
      for (int k = 0; k < lanes; ++k) block[k] = in[first + k].v;
      isa::BODYLINE_ISA_NAMESPACE::transpose_block(block);
#pragma GCC unroll 8
      for (int l = 0; l < lanes; ++l)
        isa::BODYLINE_ISA_NAMESPACE::store(array + at[l] + first, block[l]);
    }
    for (int k = blocks * lanes; k < 3 * points; ++k) {
      for (int l = 0; l < lanes; ++l) array[at[l] + k] = in[k].v[l];
    }
  }

  BODYLINE_INLINED static void add_point(double* array, const int* at, int shift, int count,
                                         const Vec3<Lane>& value) {
    each_point(value, count, [&](int l, Pair xy, double z) BODYLINE_INLINED {
      double* p = array + at[l] + shift;
      Pair sum;
      __builtin_memcpy(&sum, p, sizeof sum);
      sum += xy;
      __builtin_memcpy(p, &sum, sizeof sum);
      p[2] += z;
    });
  }

 private:
  using Pair = isa::BODYLINE_ISA_NAMESPACE::Pair;

  // visit(lane, (x, y), z) for the first `count` lanes.
  template <class Visit>
  BODYLINE_INLINED static void each_point(const Vec3<Lane>& value, int count, const Visit& visit) {
    const Lanes x = value.x.v, y = value.y.v, z = value.z.v;
#if defined(__AVX512F__)
    const auto points = isa::BODYLINE_ISA_NAMESPACE::transpose(x, y, z);
#pragma GCC unroll 8
    for (int l = 0; l < lanes; ++l) {
      if (l >= count) return;
      const Lanes both = points.of[l % 4];
      if (l < 4) {
        visit(l, __builtin_shufflevector(both, both, 0, 1), both[2]);
      } else {
        visit(l, __builtin_shufflevector(both, both, 4, 5), both[6]);
      }
    }
#else
#pragma GCC unroll 8
    for (int l = 0; l < lanes; ++l) {
      if (l >= count) return;
      visit(l, Pair{x[l], y[l]}, z[l]);
    }
#endif
  }
};

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
