#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/bounds_options.hpp"
#include "cli/command.hpp"
#include "cli/scan_target.hpp"
#include "model/drawing.hpp"
#include "optimize/feature_line.hpp"

namespace bodyline::cli {

/// Outlines and feature lines named on the command line.
struct DrawnRequest {
  std::string views;                  ///< VIEW=FILE,...
  std::vector<std::string> features;  ///< CURVE=FILE or CURVE=VIEW:FILE

  bool wanted() const { return !views.empty() || !features.empty(); }
};

/// Adds --views and --feature.
void add_drawn_target(CLI::App& command, DrawnRequest& request);

/// The same, read and laid into the coordinates of a model.
struct DrawnTarget {
  model::Model
      start;  ///< for the fit: that given, stretched to the drawings unless there is a scan
  std::vector<model::PlacedDrawing> outlines;
  std::vector<optimize::FeatureLine> features;
  std::string words;  ///< what was read and taken for granted, sentences on lines
};

/// Reads and places them: with a scan where a body lies that is fitted to it in haste, else where
/// `start` lies. Lines in space are in the coordinates of the scan, else of the model. Throws
/// io::InputError and std::invalid_argument.
DrawnTarget place_drawn(Context& context, const DrawnRequest& request,
                        const optimize::Bounds& bounds, const model::Model& start,
                        const std::optional<PlacedScan>& scan);

}  // namespace bodyline::cli
