#include "cli/drawn_target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "cli/progress.hpp"
#include "io/place_drawings.hpp"
#include "io/read_drawing.hpp"
#include "io/read_polylines.hpp"
#include "model/build.hpp"
#include "model/measures.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/outline_shift.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::cli {
namespace {

constexpr double feature_spacing = 5.0;  // mm, of the points of a curve that is drawn
constexpr double box_share = 0.005;      // of a scan's points beyond each side of its box

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

Eigen::AlignedBox3d start_box(const model::Model& start) {
  const model::Box box =
      model::bounding_box(model::build(start, model::Stage::body, model::Halves::left_and_central),
                          model::Halves::left_and_central);
  return {box.low, box.high};
}

// In the coordinates of the model, without the farthest points.
Eigen::AlignedBox3d scan_box(const PlacedScan& placed) {
  std::array<std::vector<double>, 3> coordinates;
  for (const Eigen::Vector3d& point : placed.scan.points) {
    const Eigen::Vector3d at =
        placed.pose.scale * (placed.pose.rotation * point) + placed.pose.translation;
    for (int axis = 0; axis < 3; ++axis) coordinates[axis].push_back(at[axis]);
  }
  Eigen::Vector3d low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = optimize::quantile(coordinates[axis], box_share);
    high[axis] = optimize::quantile(coordinates[axis], 1.0 - box_share);
  }
  return {low, high};
}

io::PlaceOptions place_options(const Bounds& bounds, const model::Model& start,
                               const std::optional<PlacedScan>& scan) {
  io::PlaceOptions options;
  options.body = scan ? scan_box(*scan) : start_box(start);
  for (const optimize::DimensionBound& bound : bounds.dimensions) {
    if (bound.lower != bound.upper) continue;
    if (bound.name == "length") options.length = bound.lower;
    if (bound.name == "width") options.width = bound.lower;
    if (bound.name == "height") options.height = bound.lower;
  }
  return options;
}

io::PlacedViews place_views(const std::vector<io::ViewFile>& files,
                            const io::PlaceOptions& options) {
  std::vector<io::ViewDrawing> drawings;
  for (const io::ViewFile& file : files)
    drawings.push_back({file.view, io::read_drawing(file.path), file.nose, file.scale, {}});
  return io::place_drawings(drawings, options);
}

// Moves drawings to where a body lies that is fitted to a scan in haste.
void move_to_scan(Context& context, const PlacedScan& scan, const model::Model& start,
                  io::PlacedViews& placed) {
  const Progress progress(context, "placing the outlines on the scan");
  optimize::FitOptions haste;
  haste.body_rounds = haste.unfold_rounds = 0;
  const model::Model rough = optimize::fit_scan(scan.scan, scan.pose, start, haste).model;
  const Eigen::Vector3d shift = optimize::outline_shift(rough, placed.drawings);
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

// A body drawn out from a corner of its box to the sizes that are known.
model::Model stretched(model::Model body, const Eigen::AlignedBox3d& box,
                       const Eigen::Vector3d& size) {
  const Eigen::Vector3d origin(box.min().x(), 0.0, box.min().z());
  Eigen::Vector3d factors = Eigen::Vector3d::Ones();
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 0.0) factors[axis] = size[axis] / box.sizes()[axis];
  }
  for (model::Curve& curve : body.curves) {
    for (Eigen::Vector3d& point : curve.points)
      point = origin + factors.cwiseProduct(point - origin);
  }
  return body;
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
    const double spacing = feature_spacing / move.linear().col(0).norm();
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
    for (Eigen::Vector3d& point : line)
      point = scan->pose.scale * (scan->pose.rotation * point) + scan->pose.translation;
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

DrawnTarget place_drawn(Context& context, const DrawnRequest& request, const Bounds& bounds,
                        const model::Model& start, const std::optional<PlacedScan>& scan) {
  DrawnTarget target;
  target.start = start;
  std::vector<FeatureFile> features;
  for (const std::string& text : request.features) {
    features.push_back(parse_feature(text));
    target.features.push_back({features.back().curve, features.back().view, {{}}});
  }
  optimize::check_feature_lines(start, target.features);
  std::vector<io::ViewFile> files;
  io::PlacedViews placed;
  if (!request.views.empty()) {
    files = io::parse_views(request.views);
    const io::PlaceOptions options = place_options(bounds, start, scan);
    placed = place_views(files, options);
    if (!scan && all_closed(placed.drawings))
      target.start = stretched(start, options.body, placed.size);
    target.words = size_words(files, placed.size);
    for (const std::string& note : placed.notes) target.words += "\n" + note;
  }
  if (scan && !files.empty()) move_to_scan(context, *scan, start, placed);
  target.outlines = placed.drawings;
  for (std::size_t k = 0; k < features.size(); ++k) {
    target.features[k].polylines = features[k].view ? lines_in_view(features[k], files, placed)
                                                    : lines_in_space(features[k], scan);
  }
  return target;
}

DrawnKept measure_drawn(const DrawnTarget& target, const model::Model& model) {
  DrawnKept kept;
  kept.outlines = optimize::measure_outlines(model, target.outlines);
  kept.features = optimize::measure_features(model, target.features);
  return kept;
}

nlohmann::ordered_json outlines_json(const DrawnKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const optimize::OutlineDeviation& view : kept.outlines)
    json[model::view_name(view.view)] = {{"median", view.median}, {"p90", view.p90}};
  return json;
}

nlohmann::ordered_json features_json(const DrawnKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const optimize::FeatureDeviation& feature : kept.features)
    json[feature.curve] = {{"median", feature.median}, {"p90", feature.p90}};
  return json;
}

std::string drawn_text(const DrawnKept& kept) {
  std::string text;
  const auto add = [&](const std::string& name, double median, double p90) {
    if (text.empty())
      text = fmt::format("{:<44} {:>8} {:>8}\n", "outline or line", "median", "90 %");
    text += fmt::format("{:<44} {:>8.2f} {:>8.2f}\n", name, median, p90);
  };
  for (const optimize::OutlineDeviation& view : kept.outlines)
    add("outline from " + model::view_name(view.view), view.median, view.p90);
  for (const optimize::FeatureDeviation& feature : kept.features)
    add(feature.curve, feature.median, feature.p90);
  return text.empty() ? text
                      : text +
                            "Distances in mm of what is drawn from the body's silhouettes and "
                            "curves.\n";
}

}  // namespace bodyline::cli
