#pragma once

#include "model/batch_corners.hpp"
#include "model/batch_patches.hpp"
#include "model/batch_seams.hpp"
#include "model/batch_sides.hpp"

/// The construction of a whole body, batch by batch, for any number type that has a Pack.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// All nets up to the stage. `storage` holds tables.memory numbers of type Real, aligned as Real;
/// arrays may be read one number past their ends.
template <class Real, class Number>
void build_batches(const BatchTables& tables, LastStage stage, const Number* parameters,
                   Number* nets, unsigned char* storage) {
  for (int k = 0; k < tables.patch_count; ++k) {
    build_patches<Real>(tables.patches[k], stage == LastStage::base, parameters, nets, storage);
  }
  if (stage == LastStage::base) return;
  for (int k = 0; k < tables.seam_count; ++k) build_seams<Real>(tables.seams[k], nets, storage);
  if (stage == LastStage::kept) return;
  for (int k = 0; k < tables.side_count; ++k)
    build_sides<Real>(tables.sides[k], parameters, nets, storage);
  for (int k = 0; k < tables.corner_count; ++k)
    build_corners<Real>(tables.corners[k], nets, storage);
}

/// After build_batches of the same stage and parameters: adds to the adjoints of the parameters;
/// consumes nets_bar.
template <class Real, class Number>
void batches_pullback(const BatchTables& tables, LastStage stage, const Number* parameters,
                      unsigned char* storage, Number* nets_bar, Number* parameters_bar) {
  if (stage == LastStage::body) {
    for (int k = tables.corner_count; k-- > 0;)
      corners_pullback<Real>(tables.corners[k], storage, nets_bar);
    for (int k = tables.side_count; k-- > 0;) {
      sides_pullback<Real>(tables.sides[k], parameters, storage, nets_bar, parameters_bar);
    }
  }
  if (stage != LastStage::base) {
    for (int k = tables.seam_count; k-- > 0;)
      seams_pullback<Real>(tables.seams[k], nets_bar, storage);
  }
  for (int k = tables.patch_count; k-- > 0;) {
    patches_pullback<Real>(tables.patches[k], stage == LastStage::base, parameters, nets_bar,
                           storage, parameters_bar);
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
