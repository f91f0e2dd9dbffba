#pragma once

#include <string>

#include "cli/command.hpp"
#include "io/read_scan.hpp"
#include "model/model.hpp"
#include "model/scan.hpp"
#include "optimize/align_scan.hpp"

namespace bodyline::cli {

/// A scan named on the command line, and where it lies.
struct ScanTarget {
  std::string path;
  std::string pose;      ///< empty: found; "none": the scan is in the model's coordinates
  double unit_mm = 0.0;  ///< 0: guessed
  std::size_t most_points = 200'000;          ///< used
  std::string reference = "the start model";  ///< what the model is called in sentences
};

/// Adds the positional argument SCAN and --pose, --unit and --points.
void add_scan_target(CLI::App& command, ScanTarget& target);

/// A scan with outward normals and its pose.
struct PlacedScan {
  model::Scan scan;
  model::Scan fitted;  ///< with what the start model has beyond an end that is missing
  model::Pose pose;
  optimize::AlignResult alignment;  ///< how it was found, or how what was given was judged
  bool pose_given = false, unit_given = false;
  std::string words;  ///< what was read and found, sentences for the user
};

/// Reads, aligns to `model`, estimates and turns normals, with progress. Throws io::InputError and
/// std::invalid_argument.
PlacedScan place_scan(Context& context, const ScanTarget& target, const model::Model& model);

}  // namespace bodyline::cli
