#pragma once

#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// How a number type of several lanes reads and writes arrays of plain numbers. This is the case of
/// one lane.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <class Real>
struct Pack {
  using Number = Real;  ///< what arrays hold
  static constexpr int lanes = 1;

  /// Lane l of the result is array[at[l] + shift].
  static Real read(const Number* array, const int* at, int shift) { return array[at[0] + shift]; }
  static Vec3<Real> read_point(const Number* array, const int* at, int shift) {
    const Number* p = array + at[0] + shift;
    return {p[0], p[1], p[2]};
  }
  static void write_point(Number* array, const int* at, int shift, const Vec3<Real>& value) {
    Number* p = array + at[0] + shift;
    p[0] = value.x, p[1] = value.y, p[2] = value.z;
  }
  /// Whole nets, whose points follow each other.
  static void read_net(const Number* array, const int* at, int points, Vec3<Real>* net) {
    for (int k = 0; k < points; ++k) net[k] = read_point(array, at, 3 * k);
  }
  static void write_net(Number* array, const int* at, int points, const Vec3<Real>* net) {
    for (int k = 0; k < points; ++k) write_point(array, at, 3 * k, net[k]);
  }
  /// Adds the first `count` lanes.
  static void add(Number* array, const int* at, int shift, int, const Real& value) {
    array[at[0] + shift] += value;
  }
  static void add_point(Number* array, const int* at, int shift, int, const Vec3<Real>& value) {
    Number* p = array + at[0] + shift;
    p[0] += value.x, p[1] += value.y, p[2] += value.z;
  }
  /// One plain number per lane.
  static Real numbers(const double* of_lane) { return Real(of_lane[0]); }
};

/// The next type of fewer lanes that a batch may have.
template <class Real>
struct Narrower {
  using Type = Real;
};

/// Names a type to a generic lambda.
template <class Real>
struct Width {
  using Type = Real;
};

/// act(Width of as many lanes as asked for), from Real downwards.
template <class Real, class Act>
void with_width(int lanes, const Act& act) {
  if constexpr (Pack<Real>::lanes > 1) {
    if (lanes < Pack<Real>::lanes) return with_width<typename Narrower<Real>::Type>(lanes, act);
  }
  act(Width<Real>{});
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
