#pragma once

#include "model/batch_corners.hpp"
#include "model/batch_patches.hpp"
#include "model/batch_seams.hpp"
#include "model/batch_sides.hpp"

/// The construction of a whole body, batch by batch, for any number type that has a Pack.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// act(batch, Width of its lanes) for every batch, in order or backwards.
template <class Real, class Batch, class Act>
void for_each_batch(const Batch* batches, int count, const Act& act) {
  for (int k = 0; k < count; ++k) {
    with_width<Real>(batches[k].lanes, [&](auto width) { act(batches[k], width); });
  }
}
template <class Real, class Batch, class Act>
void for_each_batch_backwards(const Batch* batches, int count, const Act& act) {
  for (int k = count; k-- > 0;) {
    with_width<Real>(batches[k].lanes, [&](auto width) { act(batches[k], width); });
  }
}

/// All nets up to the stage; no batch has more lanes than Real. `storage` holds tables.memory
/// numbers, aligned as Real; arrays may be read one number past their ends.
template <class Real, class Number>
void build_batches(const BatchTables& tables, LastStage stage, const Number* parameters,
                   Number* nets, unsigned char* storage) {
  for_each_batch<Real>(
      tables.patches, tables.patch_count, [&]<class W>(const PatchBatch& batch, Width<W>) {
        build_patches<W>(batch, stage == LastStage::base, parameters, nets, storage);
      });
  if (stage == LastStage::base) return;
  for_each_batch<Real>(
      tables.seams, tables.seam_count,
      [&]<class W>(const SeamBatch& batch, Width<W>) { build_seams<W>(batch, nets, storage); });
  if (stage == LastStage::kept) return;
  for_each_batch<Real>(tables.sides, tables.side_count,
                       [&]<class W>(const SideBatch& batch, Width<W>) {
                         build_sides<W>(batch, parameters, nets, storage);
                       });
  for_each_batch<Real>(
      tables.corners, tables.corner_count,
      [&]<class W>(const CornerBatch& batch, Width<W>) { build_corners<W>(batch, nets, storage); });
}

/// After build_batches of the same stage and parameters: adds to the adjoints of the parameters;
/// consumes nets_bar.
template <class Real, class Number>
void batches_pullback(const BatchTables& tables, LastStage stage, const Number* parameters,
                      unsigned char* storage, Number* nets_bar, Number* parameters_bar) {
  if (stage == LastStage::body) {
    for_each_batch_backwards<Real>(tables.corners, tables.corner_count,
                                   [&]<class W>(const CornerBatch& batch, Width<W>) {
                                     corners_pullback<W>(batch, storage, nets_bar);
                                   });
    for_each_batch_backwards<Real>(
        tables.sides, tables.side_count, [&]<class W>(const SideBatch& batch, Width<W>) {
          sides_pullback<W>(batch, parameters, storage, nets_bar, parameters_bar);
        });
  }
  if (stage != LastStage::base) {
    for_each_batch_backwards<Real>(tables.seams, tables.seam_count,
                                   [&]<class W>(const SeamBatch& batch, Width<W>) {
                                     seams_pullback<W>(batch, nets_bar, storage);
                                   });
  }
  for_each_batch_backwards<Real>(tables.patches, tables.patch_count,
                                 [&]<class W>(const PatchBatch& batch, Width<W>) {
                                   patches_pullback<W>(batch, stage == LastStage::base, parameters,
                                                       nets_bar, storage, parameters_bar);
                                 });
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
