#pragma once

#include "model/kernels.hpp"

/// The kernels of each instruction set, defined by kernels_impl.cpp, which is compiled once for
/// each. Those that a build does not carry are declared but not defined.
namespace bodyline::model::isa {

namespace baseline {
const Kernels& table();
}
namespace avx2 {
const Kernels& table();
}
namespace avx512 {
const Kernels& table();
}

}  // namespace bodyline::model::isa
