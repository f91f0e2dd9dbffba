#pragma once

#include "io/model_file_table.hpp"
#include "model/model.hpp"

namespace bodyline::io {

/// Fills in the curves; `scale` is the length of the file's unit in mm. Throws InputError.
void read_curves(const FileTable& root, double scale, model::Model& model);

/// Fills in the patches; the curves are there. Throws InputError.
void read_patches(const FileTable& root, model::Model& model);

}  // namespace bodyline::io
