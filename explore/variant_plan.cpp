#include "explore/variant_plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "explore/study_error.hpp"
#include "model/face_work.hpp"
#include "model/measures_wheelbase.hpp"
#include "model/suggest.hpp"

namespace bodyline::explore {
namespace {

constexpr int nodes = 8;

model::TermKind term_kind_of(MetricKind kind) { return model::term_kind(metric_name(kind)); }

void check_rake(const MetricSpec& metric, const DesignSpace& space) {
  std::vector<std::string> central;
  for (const model::Face& face : space.context()->plan.base_faces) {
    if (face.central) central.push_back(face.name);
  }
  const std::string& name = metric.faces.front();
  if (std::find(central.begin(), central.end(), name) != central.end()) return;
  throw StudyError("metrics." + metric.name + ".face",
                   "no patch across the middle is called \"" + name + "\"; the nearest is \"" +
                       model::nearest_name(name, central) + "\"");
}

bool needs_arches(MetricKind kind) {
  return kind == MetricKind::wheelbase || kind == MetricKind::front_overhang ||
         kind == MetricKind::rear_overhang;
}

}  // namespace

std::vector<std::string> cause_names(const Study& study, const DesignSpace& space) {
  std::vector<std::string> names{""};
  for (const model::Face& face : space.context()->plan.body_faces) names.push_back(face.name);
  for (const MetricSpec& metric : study.metrics) names.push_back(metric.name);
  return names;
}

model::Term term_of(const MetricSpec& metric) {
  return {term_kind_of(metric.kind), 1.0, metric.stage, metric.faces};
}

MetricTerms metric_terms(const Study& study) {
  MetricTerms terms;
  bool has_variation = false;
  for (const MetricSpec& metric : study.metrics) {
    if (!is_term(metric.kind)) continue;
    const bool apart = metric.kind == MetricKind::variation && has_variation;
    (apart ? terms.apart : terms.together).push_back(term_of(metric));
    has_variation |= metric.kind == MetricKind::variation;
  }
  return terms;
}

void check_metrics(const Study& study, const DesignSpace& space) {
  for (const MetricSpec& metric : study.metrics) {
    if (metric.kind == MetricKind::rake) check_rake(metric, space);
    if (needs_arches(metric.kind) && !model::wheelbase(study.models.front().model)) {
      throw StudyError("metrics." + metric.name,
                       "needs wheel arches, and the model has none that are parts of circles");
    }
    if (!is_term(metric.kind)) continue;
    try {
      model::plan_face_work(space.context()->plan, {term_of(metric)}, nodes);
    } catch (const std::invalid_argument& error) {
      throw StudyError("metrics." + metric.name + ".faces", error.what());
    }
  }
}

VariantPlan::VariantPlan(Study of)
    : study(std::move(of)), space(study), causes(cause_names(study, space)) {
  check_metrics(study, space);
  const model::Model& model = study.models.front().model;
  const model::BodyPlan& plan = space.context()->plan;
  for (const MetricSpec& metric : study.metrics) {
    scans.push_back(nullptr);
    outlines.push_back(nullptr);
    if (metric.kind == MetricKind::scan)
      scans.back() = std::make_unique<ScanMeter>(study.folder / metric.scan, metric, model, plan);
    if (metric.kind == MetricKind::outline)
      outlines.back() = std::make_unique<OutlineMeter>(study.folder, metric, model, plan);
  }
}

}  // namespace bodyline::explore
