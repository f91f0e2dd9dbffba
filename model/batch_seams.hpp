#pragma once

#include "model/batch_memory.hpp"
#include "model/batch_tables.hpp"

/// Correction of the second rows of both kept nets at a batch of seams, and its pullback
/// (docs/mathematics.md, section 8).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <class Real, class Number>
[[gnu::flatten]] void build_seams(const SeamBatch& batch, Number* nets, unsigned char* storage) {
  using Io = Pack<Real>;
  auto& memory = memory_at<SeamMemory<Real>, Real>(storage, batch.memory);
  SeamRows<Real>& before = memory.before;
  for (int k = 0; k <= batch.degree; ++k) {
    const int row = k * Io::lanes;
    before.edge[k] = Io::read_point(nets, batch.edge + row, 0);
    before.across_a[k] = before.edge[k] - Io::read_point(nets, batch.second_a + row, 0);
    before.across_b[k] = Io::read_point(nets, batch.second_b + row, 0) - before.edge[k];
  }
  SeamRows<Real> rows = before;
  correct_seam(batch.degree, rows, memory.trace);
  for (int k = 0; k <= batch.degree; ++k) {
    const int row = k * Io::lanes;
    Io::write_point(nets, batch.second_a + row, 0, rows.edge[k] - rows.across_a[k]);
    Io::write_point(nets, batch.second_b + row, 0, rows.edge[k] + rows.across_b[k]);
  }
}

/// Replaces the adjoints of the second rows by those before the correction, adds to those of the
/// edge.
template <class Real, class Number>
[[gnu::flatten]] void seams_pullback(const SeamBatch& batch, Number* nets_bar,
                                     unsigned char* storage) {
  using Io = Pack<Real>;
  const auto& memory = memory_at<SeamMemory<Real>, Real>(storage, batch.memory);
  SeamRows<Real> bar;
  for (int k = 0; k <= batch.degree; ++k) {
    const int row = k * Io::lanes;
    const Vec3<Real> second_a = Io::read_point(nets_bar, batch.second_a + row, 0);
    const Vec3<Real> second_b = Io::read_point(nets_bar, batch.second_b + row, 0);
    bar.edge[k] = second_a + second_b;
    bar.across_a[k] = -second_a;
    bar.across_b[k] = second_b;
  }
  correct_seam_pullback(batch.degree, memory.before, memory.trace, bar);
  for (int k = 0; k <= batch.degree; ++k) {
    const int row = k * Io::lanes;
    Io::write_point(nets_bar, batch.second_a + row, 0, -bar.across_a[k]);
    Io::write_point(nets_bar, batch.second_b + row, 0, bar.across_b[k]);
    Io::add_point(nets_bar, batch.edge + row, 0, batch.count,
                  bar.edge[k] + bar.across_a[k] - bar.across_b[k]);
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
