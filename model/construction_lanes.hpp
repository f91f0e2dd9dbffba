#pragma once

#include "model/batch_tables.hpp"

/// The batched construction of each instruction set, defined by construction_lanes.cpp, which is
/// compiled once for each. Those that a build does not carry are declared but not defined.
namespace bodyline::model {

struct LaneConstruction {
  int lanes = 0;  ///< the most that a batch may have
  /// As build_batches and batches_pullback; `storage` holds tables.memory doubles, aligned at 64
  /// bytes.
  void (*build)(const BatchTables&, LastStage, const double* parameters, double* nets,
                unsigned char* storage) = nullptr;
  void (*pullback)(const BatchTables&, LastStage, const double* parameters, unsigned char* storage,
                   double* nets_bar, double* parameters_bar) = nullptr;
};

namespace isa {
namespace baseline {
const LaneConstruction& construction();
}
namespace avx2 {
const LaneConstruction& construction();
}
namespace avx512 {
const LaneConstruction& construction();
}
}  // namespace isa

}  // namespace bodyline::model
