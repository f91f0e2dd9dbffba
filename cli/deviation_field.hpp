#pragma once

#include <optional>

#include "io/surface_field.hpp"
#include "model/model.hpp"
#include "optimize/deviation.hpp"

namespace bodyline::cli {

/// The signed distances of a scan as a field over the body: the median of the matches in each cell,
/// more cells where there are more points; unknown where the scan shows nothing. `range` is where
/// the colours end, mm; found from the distances when absent. `stage` is that of the deviation.
io::SurfaceField deviation_field(const model::Model& model, model::Stage stage,
                                 const optimize::Deviation& deviation,
                                 std::optional<double> range = {});

}  // namespace bodyline::cli
