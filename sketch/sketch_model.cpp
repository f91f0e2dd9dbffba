#include "sketch/sketch_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sketch/axis_map.hpp"
#include "sketch/combine_views.hpp"
#include "sketch/contradictions.hpp"
#include "sketch/curve_unknowns.hpp"
#include "sketch/first_curve.hpp"
#include "sketch/fit_lines.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

std::vector<SketchLine> lines_of(const std::vector<Stroke>& strokes) {
  std::vector<SketchLine> lines;
  for (const Stroke& stroke : strokes) lines.push_back(sketch_line(stroke));
  return lines;
}

std::vector<SketchLine> lines_of_curve(const std::vector<SketchLine>& lines, int curve) {
  std::vector<SketchLine> own;
  for (const SketchLine& line : lines)
    if (line.curve == curve) own.push_back(line);
  return own;
}

std::vector<std::optional<CombinedLine>> combine_all(const model::Model& model,
                                                     const std::vector<SketchLine>& lines) {
  std::vector<std::optional<CombinedLine>> combined;
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    combined.push_back(combine_views(lines_of_curve(lines, int(c)), is_central(model.curves[c])));
  return combined;
}

Points mapped(const AxisMap& map, const Points& points) {
  Points result;
  for (const Vector3d& point : points) result.push_back(map(point));
  return result;
}

// The curves of the template at the size of the drawing, and near the lines where they are known.
FitLinesStart start_of(const model::Model& model, const CurveUnknowns& unknowns,
                       const std::vector<SketchLine>& lines,
                       const std::vector<std::optional<CombinedLine>>& combined) {
  constexpr double known = 1.0, guessed = 1e-3;
  AxisMap map = map_of_boxes(model, lines);
  FitLinesStart start;
  std::vector<Points> near;
  std::vector<double> weights;
  std::vector<std::pair<Vector3d, Vector3d>> pairs;
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    const Points& given = model.curves[c].points;
    const Points shape = mapped(map, given);
    near.push_back(combined[c] ? first_curve(combined[c]->points, shape) : shape);
    weights.push_back(combined[c] ? known : guessed);
    start.known.push_back(combined[c].has_value());
    if (!combined[c]) continue;
    for (std::size_t k = 0; k < given.size(); ++k) pairs.emplace_back(given[k], near.back()[k]);
  }
  map = map_of_points(pairs, map);
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    start.shape.push_back(mapped(map, model.curves[c].points));
    if (!combined[c]) near[c] = start.shape.back();
  }
  start.unknowns = unknowns.means(near, weights);
  return start;
}

CurveReport report_on(const model::Curve& curve, const std::optional<CombinedLine>& combined) {
  CurveReport report;
  report.curve = curve.name;
  if (!combined) return report;
  report.source = CurveSource::drawn;
  report.combined = combined->views;
  report.axis = "xyz"[combined->axis];
  report.range = combined->range;
  report.apart = combined->apart;
  return report;
}

std::string note_of(const CurveReport& report) {
  if (report.source == CurveSource::missing) return "template, brought to size";
  std::string views;
  for (const CurveView& view : report.views) {
    const std::string name = model::view_name(view.view);
    if (views.find(name) == views.npos) views += (views.empty() ? "" : ", ") + name;
  }
  return "sketched: " + views;
}

}  // namespace

SketchResult sketch_model(const model::Model& start, std::span<const model::PlacedDrawing> drawings,
                          const SketchOptions& options) {
  GatheredStrokes gathered = gather_strokes(start, drawings);
  if (gathered.strokes.empty())
    throw std::invalid_argument("no path in the drawings is named after a curve of the body");
  const std::vector<SketchLine> lines = lines_of(gathered.strokes);
  const CurveUnknowns unknowns(start);
  const auto combined = combine_all(start, lines);
  const LinesFit fit =
      fit_lines(start, unknowns, lines, start_of(start, unknowns, lines, combined));
  SketchResult result{start, {}, std::move(gathered.unknown), fit.rounds};
  unknowns.write(fit.unknowns, result.model);
  for (std::size_t c = 0; c < start.curves.size(); ++c)
    result.curves.push_back(report_on(start.curves[c], combined[c]));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    CurveReport& report = result.curves[lines[k].curve];
    if (report.source == CurveSource::missing) report.source = CurveSource::half_drawn;
    const LineFit& line = fit.lines[k];
    report.views.push_back({lines[k].view, line.drawn_speed, line.rms, line.p90});
  }
  for (std::size_t c = 0; c < start.curves.size(); ++c) {
    const double tolerance = options.tolerance_of(start.curves[c].name);
    result.curves[c].contradictions = contradictions(
        result.curves[c], combined[c] ? combined[c]->length : 0.0,
        view_checks(lines_of_curve(lines, int(c)), is_central(start.curves[c])), tolerance);
    result.model.curves[c].note = note_of(result.curves[c]);
  }
  return result;
}

}  // namespace bodyline::sketch
