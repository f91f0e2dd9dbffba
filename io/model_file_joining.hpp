#pragma once

#include "io/model_file_table.hpp"
#include "model/model.hpp"

/// What joins the patches of a model file. The curves and patches of the model are there; all throw
/// InputError.
namespace bodyline::io {

void read_joints(const FileTable& root, model::Model& model);
void read_seams(const FileTable& root, model::Model& model);
void read_corners(const FileTable& root, model::Model& model);
void read_wheels(const FileTable& root, model::Model& model);

}  // namespace bodyline::io
