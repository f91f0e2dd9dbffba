#include "cli/drawn_target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "cli/progress.hpp"
#include "io/input_error.hpp"
#include "io/place_drawings.hpp"
#include "io/read_drawing.hpp"
#include "io/read_polylines.hpp"
#include "optimize/drawn_directions.hpp"
#include "optimize/fit_car.hpp"
#include "optimize/outline_shift.hpp"
#include "optimize/stretch_model.hpp"

namespace bodyline::cli {
namespace {

constexpr double drawn_spacing = 5.0;  // mm, of the points of a curve that is drawn

// "CURVE=FILE" or "CURVE=VIEW:FILE".
struct FeatureFile {
  std::string curve, path;
  std::optional<model::View> view;
};

FeatureFile parse_feature(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw std::invalid_argument("'" + text +
                                "' is no feature line; write CURVE=FILE.csv or CURVE=VIEW:FILE");
  }
  FeatureFile file{text.substr(0, equals), text.substr(equals + 1), std::nullopt};
  const std::size_t colon = file.path.find(':');
  for (const model::View view : model::all_views()) {
    if (file.path.substr(0, colon) != model::view_name(view) || colon == std::string::npos)
      continue;
    file.view = view;
    file.path.erase(0, colon + 1);
    break;
  }
  return file;
}

io::PlaceOptions place_options(const optimize::Bounds& bounds, const model::Model& start,
                               const std::optional<PlacedScan>& scan) {
  io::PlaceOptions options;
  options.body = scan ? optimize::scan_box(scan->scan, scan->pose) : optimize::body_box(start);
  for (const optimize::DimensionBound& bound : bounds.dimensions) {
    if (bound.lower != bound.upper) continue;
    if (bound.name == "length") options.length = bound.lower;
    if (bound.name == "width") options.width = bound.lower;
    if (bound.name == "height") options.height = bound.lower;
  }
  return options;
}

// `text` names the files in messages.
io::PlacedViews place_views(const std::string& text, const std::vector<io::ViewFile>& files,
                            const io::PlaceOptions& options) {
  std::vector<io::ViewDrawing> drawings;
  for (const io::ViewFile& file : files)
    drawings.push_back({file.view, io::read_drawing(file.path), file.nose, file.scale, {}});
  try {
    return io::place_drawings(drawings, options);
  } catch (const io::NoScale& error) {
    const bool seen_along = error.view() != model::View::side && error.view() != model::View::top;
    throw io::InputError(
        text, 0, "",
        fmt::format("{}: {}=FILE@1 where a unit of the drawing is 1 mm of the car, or --dimension "
                    "{}=MM",
                    error.what(), model::view_name(error.view()), seen_along ? "width" : "length"));
  } catch (const std::invalid_argument& error) {
    throw io::InputError(text, 0, "", error.what());
  }
}

// Moves drawings to where a body lies that is fitted to a scan in haste.
void move_to_scan(Context& context, const PlacedScan& scan, const model::Model& start,
                  io::PlacedViews& placed) {
  const Progress progress(context, "placing the outlines on the scan");
  const Eigen::Vector3d shift =
      optimize::shift_to_scan(placed.drawings, {scan.scan, scan.pose}, start);
  for (std::size_t k = 0; k < placed.moves.size(); ++k)
    placed.moves[k].pretranslate(model::project(placed.drawings[k].view, shift));
  placed.drawings = optimize::shifted(std::move(placed.drawings), shift);
}

// Whether every drawing shows a whole outline; a part of one does not tell sizes.
bool all_closed(const std::vector<model::PlacedDrawing>& drawings) {
  return std::all_of(drawings.begin(), drawings.end(), [](const model::PlacedDrawing& drawing) {
    return std::any_of(drawing.paths.begin(), drawing.paths.end(),
                       [](const model::DrawnPath& path) { return path.closed; });
  });
}

// Which views seem to have nose and tail exchanged.
std::string nose_words(const model::Model& start, const io::PlacedViews& placed) {
  const auto found = optimize::drawn_directions(start, placed.drawings);
  std::string words;
  for (const model::View view : found.reversed) {
    words += fmt::format(
        "\nTHE VIEW {0} LOOKS AS IF ITS NOSE POINTED THE OTHER WAY{1}: write {0}=FILE:nose-right "
        "where the drawing has it on the right, and leave that out where it has it on the left.",
        model::view_name(view),
        found.as_said.empty() ? ""
                              : ", unlike the view " + model::view_name(found.as_said.front()));
  }
  return words;
}

std::string size_words(const std::vector<io::ViewFile>& files, const Eigen::Vector3d& size) {
  std::vector<std::string> names, sizes;
  for (const io::ViewFile& file : files) names.push_back(model::view_name(file.view));
  const char* const words[] = {"long", "wide", "high"};
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 0.0) sizes.push_back(fmt::format("{:.0f} mm {}", size[axis], words[axis]));
  }
  return fmt::format("Outlines in {}: {}.", fmt::join(names, ", "), fmt::join(sizes, ", "));
}

// A drawn line that lies in a view's drawing, or in the picture itself when there is none.
std::vector<std::vector<Eigen::Vector3d>> lines_in_view(const FeatureFile& file,
                                                        const std::vector<io::ViewFile>& files,
                                                        const io::PlacedViews& placed) {
  const model::Drawing drawing = io::read_drawing(file.path);
  Eigen::Affine2d move(Eigen::Scaling(drawing.unit_mm > 0.0 ? drawing.unit_mm : 1.0));
  for (std::size_t k = 0; k < files.size(); ++k) {
    if (files[k].view == *file.view) move = placed.moves[k];
  }
  std::vector<std::vector<Eigen::Vector3d>> lines;
  for (const model::DrawnPath& path : drawing.paths) {
    std::vector<Eigen::Vector3d>& line = lines.emplace_back();
    const double spacing = drawn_spacing / move.linear().col(0).norm();
    for (const Eigen::Vector2d& point : model::sample_path(path, spacing)) {
      const Eigen::Vector2d at = move * point;
      line.emplace_back(at.x(), at.y(), 0.0);
    }
  }
  return lines;
}

std::vector<std::vector<Eigen::Vector3d>> lines_in_space(const FeatureFile& file,
                                                         const std::optional<PlacedScan>& scan) {
  std::vector<std::vector<Eigen::Vector3d>> lines = io::read_polylines(file.path);
  if (!scan) return lines;
  for (std::vector<Eigen::Vector3d>& line : lines) {
    for (Eigen::Vector3d& point : line) point = model::to_model(scan->pose, point);
  }
  return lines;
}

}  // namespace

void add_drawn_target(CLI::App& command, DrawnRequest& request) {
  command
      .add_option("--views", request.views,
                  "Outlines, VIEW=FILE[@MM_PER_UNIT] separated by commas; views are side, top, "
                  "front, rear; files .svg, .png, .csv")
      ->type_name("VIEWS");
  command
      .add_option("--feature", request.features,
                  "Line that a curve of the body shall follow, CURVE=FILE.csv (x y z) or "
                  "CURVE=VIEW:FILE; may be repeated")
      ->type_name("LINE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

DrawnTarget place_drawn(Context& context, const DrawnRequest& request,
                        const optimize::Bounds& bounds, const model::Model& start,
                        const std::optional<PlacedScan>& scan) {
  DrawnTarget target;
  target.start = start;
  std::vector<FeatureFile> features;
  for (const std::string& text : request.features) {
    features.push_back(parse_feature(text));
    target.features.push_back({features.back().curve, features.back().view, {{}}});
  }
  optimize::check_feature_curves(start, target.features);
  std::vector<io::ViewFile> files;
  io::PlacedViews placed;
  if (!request.views.empty()) {
    files = io::parse_views(request.views);
    const io::PlaceOptions options = place_options(bounds, start, scan);
    placed = place_views(request.views, files, options);
    if (!scan && all_closed(placed.drawings))
      target.start = optimize::stretched(start, options.body, placed.size);
    target.words = size_words(files, placed.size);
    for (const std::string& note : placed.notes) target.words += "\n" + note;
    if (!scan && all_closed(placed.drawings)) target.words += nose_words(target.start, placed);
  }
  if (scan && !files.empty()) move_to_scan(context, *scan, start, placed);
  target.outlines = placed.drawings;
  for (std::size_t k = 0; k < features.size(); ++k) {
    target.features[k].polylines = features[k].view ? lines_in_view(features[k], files, placed)
                                                    : lines_in_space(features[k], scan);
    try {
      optimize::check_feature_points(target.features[k]);
    } catch (const std::invalid_argument& error) {
      throw io::InputError(features[k].path, 0, "", error.what());
    }
  }
  return target;
}

}  // namespace bodyline::cli
