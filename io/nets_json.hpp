#pragma once

#include <string>

#include "model/model.hpp"

namespace bodyline::io {

/// All control nets of a body as JSON (docs/export.md): "base", "kept", "transition" and "corner",
/// each a table from a face's name to {"degree": [m, n], "net": [[[x, y, z], ...], ...]}, net[i][j]
/// with i along u and j along v; a face with a Gregory term has "blend" and "blend_note" too.
/// Numbers read back as the same doubles. `model_text`, the text of the model file, is kept under
/// "model", so that the model can be recovered exactly. Throws what model::build throws.
std::string nets_json(const model::Model& model, const std::string& model_text);

/// The text under "model" of such a file. `name` stands for the file in messages. Throws InputError
/// when `json` is not JSON or carries no model.
std::string model_text_from_json(const std::string& json, const std::string& name);

}  // namespace bodyline::io
