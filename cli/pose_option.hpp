#pragma once

#include <string>

#include "model/scan.hpp"

namespace bodyline::cli {

/// A pose of seven numbers "rx,ry,rz,tx,ty,tz,scale": the scan is turned about the x axis by rx
/// degrees, about y by ry, about z by rz, scaled, and moved by tx, ty, tz mm; then it lies on the
/// model. Throws std::invalid_argument, with the range of a number that is beyond it.
model::Pose pose_from_text(const std::string& text);

/// The text of a pose, with enough digits to read it back within rounding.
std::string pose_text(const model::Pose& pose);

/// A sentence on how a pose that was found moves the scan, with the options that repeat or avoid
/// it.
std::string moved_frame_words(const model::Pose& pose);

}  // namespace bodyline::cli
