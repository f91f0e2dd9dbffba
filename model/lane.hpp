#pragma once

#include "model/kernel_lanes.hpp"
#include "model/lane_transpose.hpp"
#include "model/packs.hpp"

/// A number of several lanes: one double of each of several steps of the same kind, so that the
/// templates of the stages build several faces at once. Only for sources that are compiled once per
/// instruction set.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

template <int Count>
struct Lane {
  using Vector = LaneVector<Count>;
  Vector v;

  Lane() = default;
  BODYLINE_INLINED explicit Lane(double x) : v(x - Vector{}) {}
  BODYLINE_INLINED explicit Lane(Vector x) : v(x) {}

  BODYLINE_INLINED Lane& operator+=(Lane b) { return v += b.v, *this; }
  BODYLINE_INLINED Lane& operator-=(Lane b) { return v -= b.v, *this; }
  BODYLINE_INLINED friend Lane operator+(Lane a, Lane b) { return Lane(a.v + b.v); }
  BODYLINE_INLINED friend Lane operator-(Lane a, Lane b) { return Lane(a.v - b.v); }
  BODYLINE_INLINED friend Lane operator-(Lane a) { return Lane(-a.v); }
  BODYLINE_INLINED friend Lane operator*(Lane a, Lane b) { return Lane(a.v * b.v); }
  BODYLINE_INLINED friend Lane operator/(Lane a, Lane b) { return Lane(a.v / b.v); }
  BODYLINE_INLINED friend Lane sqrt(Lane a) { return Lane(lane_sqrt(a.v)); }
  BODYLINE_INLINED friend Lane where_at_least(const Lane& x, const Lane& floor, const Lane& yes,
                                              const Lane& no) {
    return Lane(x.v >= floor.v ? yes.v : no.v);
  }
};

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE

namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <int Count>
struct Pack<isa::BODYLINE_ISA_NAMESPACE::Lane<Count>> {
  using Number = double;
  using Lane = isa::BODYLINE_ISA_NAMESPACE::Lane<Count>;
  using Vector = typename Lane::Vector;
  static constexpr int lanes = Count;

  BODYLINE_INLINED static Lane read(const double* array, const int* at, int shift) {
    const double* p = array + shift;
    if constexpr (Count == 8) {
      return Lane(
          Vector{p[at[0]], p[at[1]], p[at[2]], p[at[3]], p[at[4]], p[at[5]], p[at[6]], p[at[7]]});
    } else if constexpr (Count == 4) {
      return Lane(Vector{p[at[0]], p[at[1]], p[at[2]], p[at[3]]});
    } else {
      return Lane(Vector{p[at[0]], p[at[1]]});
    }
  }

  BODYLINE_INLINED static void add(double* array, const int* at, int shift, int count,
                                   const Lane& value) {
#pragma GCC unroll 8
    for (int l = 0; l < Count; ++l) {
      if (l >= count) return;
      array[at[l] + shift] += value.v[l];
    }
  }

  BODYLINE_INLINED static Lane numbers(const double* of_lane) { return Lane(load(of_lane)); }

  /// Reads one number past the point.
  BODYLINE_INLINED static Vec3<Lane> read_point(const double* array, const int* at, int shift) {
    if constexpr (Count == 2) {
      return {read(array, at, shift), read(array, at, shift + 1), read(array, at, shift + 2)};
    } else {
      using namespace isa::BODYLINE_ISA_NAMESPACE;
      Vector xyz[3];
      gather_points(array + shift, at, xyz);
      return {Lane(xyz[0]), Lane(xyz[1]), Lane(xyz[2])};
    }
  }

  /// Lanes that repeat a step write the same point again.
  BODYLINE_INLINED static void write_point(double* array, const int* at, int shift,
                                           const Vec3<Lane>& value) {
    each_point(value, Count, [&](int l, Pair xy, double z) BODYLINE_INLINED {
      double* p = array + at[l] + shift;
      __builtin_memcpy(p, &xy, sizeof xy);
      p[2] = z;
    });
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

  BODYLINE_INLINED static void read_net(const double* array, const int* at, int points,
                                        Vec3<Lane>* net) {
    Lane* out = &net->x;
    const int blocks = 3 * points / Count;
    for (int b = 0; b < blocks; ++b) {
      Vector block[Count];
#pragma GCC unroll 8
      for (int l = 0; l < Count; ++l) block[l] = load(array + at[l] + b * Count);
      isa::BODYLINE_ISA_NAMESPACE::transpose_block(block);
#pragma GCC unroll 8
      for (int k = 0; k < Count; ++k) out[b * Count + k] = Lane(block[k]);
    }
    for (int k = blocks * Count; k < 3 * points; ++k) out[k] = read(array, at, k);
  }

  BODYLINE_INLINED static void write_net(double* array, const int* at, int points,
                                         const Vec3<Lane>* net) {
    const Lane* in = &net->x;
    const int blocks = 3 * points / Count;
    for (int b = 0; b < blocks; ++b) {
      Vector block[Count];
#pragma GCC unroll 8
      for (int k = 0; k < Count; ++k) block[k] = in[b * Count + k].v;
      isa::BODYLINE_ISA_NAMESPACE::transpose_block(block);
#pragma GCC unroll 8
      for (int l = 0; l < Count; ++l)
        __builtin_memcpy(array + at[l] + b * Count, &block[l], sizeof block[l]);
    }
    for (int k = blocks * Count; k < 3 * points; ++k) {
#pragma GCC unroll 8
      for (int l = 0; l < Count; ++l) array[at[l] + k] = in[k].v[l];
    }
  }

 private:
  using Pair = isa::BODYLINE_ISA_NAMESPACE::Pair;

  BODYLINE_INLINED static Vector load(const double* p) {
    Vector x;
    __builtin_memcpy(&x, p, sizeof x);
    return x;
  }

  // visit(lane, (x, y), z) for the first `count` lanes.
  template <class Visit>
  BODYLINE_INLINED static void each_point(const Vec3<Lane>& value, int count, const Visit& visit) {
    const Vector x = value.x.v, y = value.y.v, z = value.z.v;
    if constexpr (Count == 8) {
      using namespace isa::BODYLINE_ISA_NAMESPACE;
      const auto points = transpose_points(x, y, z);
#pragma GCC unroll 8
      for (int l = 0; l < Count; ++l) {
        if (l >= count) return;
        const Vector both = points.of[l % 4];
        if (l < 4) {
          visit(l, __builtin_shufflevector(both, both, 0, 1), both[2]);
        } else {
          visit(l, __builtin_shufflevector(both, both, 4, 5), both[6]);
        }
      }
    } else {
#pragma GCC unroll 8
      for (int l = 0; l < Count; ++l) {
        if (l >= count) return;
        visit(l, Pair{x[l], y[l]}, z[l]);
      }
    }
  }
};

/// Widths that batches may have, widest first.
template <>
struct Narrower<isa::BODYLINE_ISA_NAMESPACE::Lane<8>> {
  using Type = isa::BODYLINE_ISA_NAMESPACE::Lane<4>;
};
template <>
struct Narrower<isa::BODYLINE_ISA_NAMESPACE::Lane<4>> {
  using Type = double;
};
template <>
struct Narrower<isa::BODYLINE_ISA_NAMESPACE::Lane<2>> {
  using Type = double;
};

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
