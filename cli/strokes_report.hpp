#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/export.hpp"
#include "model/check_face_net.hpp"
#include "model/stroke.hpp"
#include "strokes/build_surface.hpp"

namespace bodyline::cli {

/// A patch that was refined, and the largest angles to its neighbours.
struct RefinedPatch {
  std::string name;
  double border_before_deg = 0.0, border_deg = 0.0;
};

/// What `bodyline strokes` made, for people and for programs.
struct StrokesReport {
  const std::vector<model::Stroke>* strokes = nullptr;
  const strokes::SurfaceBuild* build = nullptr;
  const model::FaceNet* net = nullptr;
  model::FaceNetCheck check;
  std::vector<std::string> findings;
  std::optional<RefinedPatch> refined;
};

/// Adds to the findings of the smooth method strokes that the surface misses by more than the
/// tolerance and what their ends were moved, where no later stroke moved them, and a boundary that
/// misses its strokes by more than the tolerance.
void add_stroke_findings(StrokesReport& report);

/// Tables of strokes and sizes, and what is wrong.
std::string strokes_text(const StrokesReport& report);

/// The same as JSON.
nlohmann::ordered_json strokes_json(const StrokesReport& report);

/// What the output holds when it is a .json file: all strokes, from which `bodyline strokes` makes
/// the same again, and the nets of all faces.
std::string strokes_document(const StrokesReport& report);

}  // namespace bodyline::cli
