#include "io/report_facts.hpp"

#include <tbb/parallel_invoke.h>

#include <cmath>
#include <limits>

#include "model/check_findings.hpp"

namespace bodyline::io {

ReportFacts report_facts(const FairReport& report) {
  ReportFacts facts;
  tbb::parallel_invoke([&] { facts.before = model::check_body(report.before); },
                       [&] { facts.after = model::check_body(report.after); });
  facts.findings_before = model::check_findings(facts.before);
  facts.findings_after = model::check_findings(facts.after);
  return facts;
}

std::vector<std::string> folded_faces(const model::BodyCheck& check, model::Stage stage) {
  std::vector<std::string> names;
  for (const model::FaceCheck& face : check.faces) {
    if (face.fold.folded && face.stage == stage) names.push_back(face.name);
  }
  return names;
}

JointFacts joint_facts(const model::BodyCheck& check) {
  JointFacts facts;
  for (const model::EdgeCheck& edge : check.edges) {
    if (edge.kind != model::EdgeKind::joint || edge.stage != model::Stage::body) continue;
    const double deviation = edge.deviation.normal_deviation_deg;
    ++facts.joints;
    if (!(deviation <= model::CheckTolerances{}.normal_deg)) ++facts.kinked;
    if (!(deviation <= facts.worst_deg)) facts.worst_deg = deviation;
    if (std::isnan(deviation)) facts.worst_deg = std::numeric_limits<double>::quiet_NaN();
  }
  return facts;
}

}  // namespace bodyline::io
