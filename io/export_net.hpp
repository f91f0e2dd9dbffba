#pragma once

#include <filesystem>
#include <string>

#include "io/export.hpp"
#include "model/face_net.hpp"

namespace bodyline::io {

/// Writes the faces of a net to a file in the format of its extension, at once or not at all: any
/// of export_extensions() (docs/export.md); of `options` the tolerance and `overwrite` count.
/// `json` is what a .json file holds. Throws as export_body does.
ExportReport export_net(const model::FaceNet& net, const std::filesystem::path& path,
                        const ExportOptions& options, const std::string& json);

/// The nets of all faces as JSON text: "faces", by name {"degree": [m, n], "breaks": [u, v], "net":
/// rows along u of Bezier points} (and "blend" of a Gregory face), and "edges", the points that
/// faces share.
std::string net_json_text(const model::FaceNet& net);

}  // namespace bodyline::io
