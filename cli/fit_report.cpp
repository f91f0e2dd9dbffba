#include "cli/fit_report.hpp"

#include "cli/deviation_field.hpp"
#include "cli/held_interrupt.hpp"
#include "cli/progress.hpp"
#include "io/write_file.hpp"

namespace bodyline::cli {
namespace {

io::ReportDistances report_distances(const optimize::Distances& d) {
  return {d.median, d.p90, d.p99, d.trimmed_rms};
}

}  // namespace

io::FitReport deviation_report(const model::Model& model, model::Stage stage,
                               const PlacedScan& placed, const optimize::Deviation& deviation,
                               const ReportRequest& request) {
  io::FitReport report;
  report.title = model.name.empty() ? "Body and scan" : model.name;
  report.words = placed.words;
  if (!placed.alignment.warning.empty()) report.warnings.push_back(placed.alignment.warning);
  report.body = model;
  report.stage = stage;
  report.pose = placed.pose;
  report.field = deviation_field(model, stage, deviation, request.range);
  report.distances = report_distances(deviation.distances);
  for (const optimize::FaceDeviation& face : deviation.faces) {
    report.faces.push_back({face.name, face.points, face.seen, report_distances(face.distances)});
  }
  report.unseen_patches = deviation.unseen_patches;
  for (std::size_t k = 0; k < deviation.matches.size(); ++k) {
    report.points.push_back({deviation.scan.points[k], deviation.matches[k].distance});
  }
  report.sections = section_planes(request);
  return report;
}

io::FitReport fit_report(const FittedCar& car, const model::Model& start,
                         const ReportRequest& request) {
  io::FitReport report;
  if (car.deviation) {
    report =
        deviation_report(car.result.model, model::Stage::body, *car.scan, *car.deviation, request);
    for (const std::string& words : arch_warnings(car.arches)) report.warnings.push_back(words);
    if (const std::string words = hidden_arches(car.result.model, car.arches); !words.empty())
      report.warnings.push_back(words);
  } else {
    report.title = car.result.model.name;
    report.body = car.result.model;
    report.scan = false;
    report.sections = section_planes(request);
  }
  if (!car.drawn.words.empty())
    report.words += (report.words.empty() ? "" : "\n") + car.drawn.words;
  for (const optimize::OutlineDeviation& view : car.kept.outlines) {
    report.outlines.push_back({model::view_name(view.view), view.median, view.p90, view.points,
                               view.distances, view.silhouette});
  }
  for (const optimize::FeatureDeviation& line : car.kept.features)
    report.lines.push_back({line.curve, line.median, line.p90});
  report.before = start;
  report.status = optimize::status_words(car.result.status);
  report.folded_faces = car.result.folded_faces;
  for (const optimize::FitProgress& round : car.result.history) {
    report.history.push_back({round.phase, round.distance, round.seconds});
  }
  report.seconds = car.result.seconds;
  return report;
}

std::string report_page(Context& context, io::FitReport& report, const ReportRequest& request) {
  const Progress progress(context, "writing " + request.output.path);
  report.command = context.command_line;
  return io::fit_report_page(report, io::fit_report_pictures);
}

void write_report_page(const std::string& page, const ReportRequest& request) {
  const HeldInterrupt whole_file;
  io::write_file(request.output.path, page,
                 request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
}

}  // namespace bodyline::cli
