#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_error.hpp"
#include "model/model.hpp"

namespace bodyline::io {

/// Reads a model file (docs/model-format.md) and checks that it describes a connected body.
/// Lengths are converted to mm; tables keep the order of the file. Throws InputError when the file
/// cannot be read or is not a valid model. What is accepted but remarkable, such as shape values
/// outside the range in which the basis is positive, is appended to `warnings` unless that is null.
model::Model read_model(const std::filesystem::path& path,
                        std::vector<Warning>* warnings = nullptr);

/// The same for a text in memory; `name` stands for the file in messages.
model::Model read_model_text(std::string_view text, const std::string& name,
                             std::vector<Warning>* warnings = nullptr);

}  // namespace bodyline::io
