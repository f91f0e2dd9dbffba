#pragma once

#include <filesystem>
#include <vector>

#include "io/input_error.hpp"
#include "io/write_file.hpp"

namespace bodyline::io {

/// Converts a file that carries a model to a model file (.toml). From .toml: the model written
/// anew, in mm and in the order the program writes. From the .json of `export_body`: the embedded
/// model text, byte for byte. Throws InputError when a file cannot be read, carries no valid model,
/// or may not be written.
void convert(const std::filesystem::path& from, const std::filesystem::path& to,
             Overwrite overwrite = Overwrite::never, std::vector<Warning>* warnings = nullptr);

}  // namespace bodyline::io
