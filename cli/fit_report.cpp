#include "cli/fit_report.hpp"

#include "cli/deviation_field.hpp"
#include "cli/progress.hpp"

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
  report.body = model;
  report.stage = stage;
  report.pose = placed.pose;
  report.field = deviation_field(model, stage, deviation, request.range);
  report.distances = report_distances(deviation.distances);
  for (const optimize::FaceDeviation& face : deviation.faces) {
    report.faces.push_back(
        {face.name, face.points, face.seen, face.mean, report_distances(face.distances)});
  }
  report.unseen_patches = deviation.unseen_patches;
  for (std::size_t k = 0; k < deviation.matches.size(); ++k) {
    report.points.push_back({deviation.scan.points[k], deviation.matches[k].distance});
  }
  report.sections = section_planes(request);
  return report;
}

void add_fit(io::FitReport& report, const model::Model& start, const optimize::FitResult& result) {
  report.before = start;
  report.status = optimize::status_words(result.status);
  report.folded_faces = result.folded_faces;
  for (const optimize::FitProgress& round : result.history) {
    report.history.push_back({round.phase, round.distance, round.seconds});
  }
  report.seconds = result.seconds;
}

void write_report(Context& context, io::FitReport& report, const ReportRequest& request) {
  const Progress progress(context, "writing " + request.output.path);
  report.command = context.command_line;
  io::write_fit_report(report, request.output.path,
                       request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
}

}  // namespace bodyline::cli
