#pragma once

#include <filesystem>
#include <string>

#include "io/write_file.hpp"
#include "model/model.hpp"

namespace bodyline::io {

/// The text of a model file. Reading it again gives the same model bit for bit: numbers are written
/// with as few digits as identify the double. Throws std::invalid_argument for a model that no file
/// can hold: a number that is not finite, an index out of range, a name that is not made of
/// letters, digits and underscores.
std::string write_model_text(const model::Model& model);

/// Writes the file at once or not at all (see write_file).
void write_model(const model::Model& model, const std::filesystem::path& path,
                 Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
