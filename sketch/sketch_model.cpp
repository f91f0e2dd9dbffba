#include "sketch/sketch_model.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "sketch/axis_map.hpp"
#include "sketch/combine_views.hpp"
#include "sketch/curve_unknowns.hpp"
#include "sketch/first_curve.hpp"
#include "sketch/fit_lines.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

// Ends of two drawings may differ by this part of the line's length, since lines are drawn too far
// or not far enough.
constexpr double careless_ends = 0.06;

std::vector<SketchLine> lines_of(const std::vector<Stroke>& strokes) {
  std::vector<SketchLine> lines;
  for (const Stroke& stroke : strokes) lines.push_back(sketch_line(stroke));
  return lines;
}

std::vector<std::optional<CombinedLine>> combine_all(const model::Model& model,
                                                     const std::vector<SketchLine>& lines) {
  std::vector<std::optional<CombinedLine>> combined;
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    std::vector<SketchLine> own;
    for (const SketchLine& line : lines)
      if (line.curve == int(c)) own.push_back(line);
    combined.push_back(combine_views(own, is_central(model.curves[c])));
  }
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

std::string sentence(const std::string& begin, double distance, const std::string& end) {
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << begin << distance << end;
  return text.str();
}

void add_contradictions(CurveReport& report, double length, const SketchOptions& options) {
  for (const CurveView& view : report.views)
    if (view.p90 > options.tolerance)
      report.contradictions.push_back(
          sentence("a tenth of the line drawn in the view " + model::view_name(view.view) + " is ",
                   view.p90, " mm and more away from the curve that meets all views best"));
  const double allowed = std::max(options.tolerance, careless_ends * length);
  if (report.source == CurveSource::drawn && report.apart > allowed)
    report.contradictions.push_back(sentence(
        "its ends in the views " + model::view_name(report.combined[0]) + " and " +
            model::view_name(report.combined[1]) + " differ in " + report.axis + " by up to ",
        report.apart, " mm"));
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
    add_contradictions(result.curves[c], combined[c] ? combined[c]->length : 0.0, options);
    result.model.curves[c].note = note_of(result.curves[c]);
  }
  return result;
}

}  // namespace bodyline::sketch
