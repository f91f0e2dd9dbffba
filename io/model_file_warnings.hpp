#pragma once

#include <vector>

#include "io/input_error.hpp"
#include "io/model_file.hpp"
#include "model/model.hpp"

namespace bodyline::io {

/// Appends what is accepted but remarkable: shape values outside the range in which the basis is
/// positive (section 2).
void append_warnings(const ModelFile& file, const model::Model& model,
                     std::vector<Warning>& warnings);

}  // namespace bodyline::io
