#pragma once

#include "model/batch_memory.hpp"
#include "model/batch_tables.hpp"
#include "model/cut.hpp"
#include "model/sq_coons.hpp"
#include "model/unrolled.hpp"

/// Base and kept nets of a batch of patches, and their pullback (docs/mathematics.md, sections 3
/// and 5).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

inline constexpr int max_patch_points = (max_patch_degree + 1) * (max_patch_degree + 1);

/// Calls act(m, n), with degrees that the compiler knows for the common ones.
template <class Act>
void with_degrees(int m, int n, const Act& act) {
  if (m == 3 && n == 3) return act(Index<3>{}, Index<3>{});
  if (m == 3 && n == 5) return act(Index<3>{}, Index<5>{});
  if (m == 5 && n == 3) return act(Index<5>{}, Index<3>{});
  act(m, n);
}

template <class Real, class Number>
void read_shapes(const PatchBatch& batch, const Number* parameters, Real* shape_u, Real* shape_v) {
  for (int k = 0; k + 1 < batch.degree_u; ++k)
    shape_u[k] = Pack<Real>::read(parameters, batch.shape_u, k);
  for (int k = 0; k + 1 < batch.degree_v; ++k)
    shape_v[k] = Pack<Real>::read(parameters, batch.shape_v, k);
}

template <class Real, class DegreeU, class DegreeV, class Number>
void build_base_nets(const PatchBatch& batch, DegreeU m, DegreeV n, const Number* parameters,
                     Number* nets, const PatchMemory<Real>& memory) {
  using Io = Pack<Real>;
  for (int b = 0; b < batch.boundary_count; ++b) {
    Vec3<Real> point = Io::read_point(parameters, batch.boundary + b * Io::lanes, 0);
    point.y = Io::numbers(batch.boundary_sign + b * Io::lanes) * point.y;
    memory.base[batch.boundary_net[b]] = point;
  }
  Real shape_u[max_patch_degree], shape_v[max_patch_degree];
  read_shapes(batch, parameters, shape_u, shape_v);
  sq_coons(m, n, memory.base, shape_u, shape_v);
  Io::write_net(nets, batch.base, (m + 1) * (n + 1), memory.base);
}

template <class Real, class DegreeU, class DegreeV, class Number>
void build_kept_nets(const PatchBatch& batch, DegreeU m, DegreeV n, const Number* parameters,
                     Number* nets, const PatchMemory<Real>& memory) {
  using Io = Pack<Real>;
  const auto limit = [&](int k) { return Io::read(parameters, batch.cut, k); };
  cut_matrix(m, limit(0), limit(1), memory.in_u);
  cut_matrix(n, limit(2), limit(3), memory.in_v);
  cut(m, n, memory.in_u, memory.in_v, memory.base, memory.kept);
  Io::write_net(nets, batch.kept, (m + 1) * (n + 1), memory.kept);
}

/// Base nets, and kept nets unless `base_only`.
template <class Real, class Number>
[[gnu::flatten]] void build_patches(const PatchBatch& batch, bool base_only,
                                    const Number* parameters, Number* nets,
                                    unsigned char* storage) {
  with_degrees(batch.degree_u, batch.degree_v, [&](auto m, auto n) {
    const PatchMemory<Real> memory = patch_memory_at<Real>(storage, batch.memory, m, n);
    build_base_nets(batch, m, n, parameters, nets, memory);
    if (!base_only) build_kept_nets(batch, m, n, parameters, nets, memory);
  });
}

/// Adds to the adjoints of the base net and of the cuts.
template <class Real, class DegreeU, class DegreeV, class Number>
void kept_nets_pullback(const PatchBatch& batch, DegreeU m, DegreeV n, const Number* parameters,
                        const Number* nets_bar, const PatchMemory<Real>& memory,
                        Vec3<Real>* base_bar, Number* parameters_bar) {
  using Io = Pack<Real>;
  Vec3<Real> kept_bar[max_patch_points];
  Io::read_net(nets_bar, batch.kept, (m + 1) * (n + 1), kept_bar);
  const auto limit = [&](int k) { return Io::read(parameters, batch.cut, k); };
  const CutBar<Real> bar =
      cut_range_pullback(m, n, limit(1) - limit(0), limit(3) - limit(2), memory.kept, kept_bar);
  Io::add(parameters_bar, batch.cut, 0, batch.count, bar.u_lo);
  Io::add(parameters_bar, batch.cut, 1, batch.count, bar.u_hi);
  Io::add(parameters_bar, batch.cut, 2, batch.count, bar.v_lo);
  Io::add(parameters_bar, batch.cut, 3, batch.count, bar.v_hi);
  cut_pullback(m, n, memory.in_u, memory.in_v, kept_bar, base_bar);
}

template <class Real, class DegreeU, class DegreeV, class Number>
void base_nets_pullback(const PatchBatch& batch, DegreeU m, DegreeV n, const Number* parameters,
                        const PatchMemory<Real>& memory, Vec3<Real>* base_bar,
                        Number* parameters_bar) {
  using Io = Pack<Real>;
  Real shape_u[max_patch_degree], shape_v[max_patch_degree];
  Real shape_u_bar[max_patch_degree] = {}, shape_v_bar[max_patch_degree] = {};
  read_shapes(batch, parameters, shape_u, shape_v);
  sq_coons_pullback(m, n, memory.base, shape_u, shape_v, base_bar, shape_u_bar, shape_v_bar);
  for (int k = 0; k + 1 < m; ++k)
    Io::add(parameters_bar, batch.shape_u, k, batch.count, shape_u_bar[k]);
  for (int k = 0; k + 1 < n; ++k)
    Io::add(parameters_bar, batch.shape_v, k, batch.count, shape_v_bar[k]);
  for (int b = 0; b < batch.boundary_count; ++b) {
    Vec3<Real> bar = base_bar[batch.boundary_net[b]];
    bar.y = Io::numbers(batch.boundary_sign + b * Io::lanes) * bar.y;
    Io::add_point(parameters_bar, batch.boundary + b * Io::lanes, 0, batch.count, bar);
  }
}

template <class Real, class Number>
[[gnu::flatten]] void patches_pullback(const PatchBatch& batch, bool base_only,
                                       const Number* parameters, const Number* nets_bar,
                                       unsigned char* storage, Number* parameters_bar) {
  with_degrees(batch.degree_u, batch.degree_v, [&](auto m, auto n) {
    const PatchMemory<Real> memory = patch_memory_at<Real>(storage, batch.memory, m, n);
    Vec3<Real> base_bar[max_patch_points];
    Pack<Real>::read_net(nets_bar, batch.base, (m + 1) * (n + 1), base_bar);
    if (!base_only)
      kept_nets_pullback(batch, m, n, parameters, nets_bar, memory, base_bar, parameters_bar);
    base_nets_pullback(batch, m, n, parameters, memory, base_bar, parameters_bar);
  });
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
