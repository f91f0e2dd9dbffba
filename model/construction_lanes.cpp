// Compiled once per instruction set, with BODYLINE_ISA_NAMESPACE naming the set. As in
// kernels_impl.cpp nothing of another namespace may be instantiated or inlined here.

#include "model/construction_lanes.hpp"

#include "model/batch_construction.hpp"
#include "model/lane.hpp"

namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

const LaneConstruction& construction() {
  static constexpr LaneConstruction functions = {
      .lanes = lanes,
      .build = build_batches<Lane<lanes>, double>,
      .pullback = batches_pullback<Lane<lanes>, double>,
  };
  return functions;
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
