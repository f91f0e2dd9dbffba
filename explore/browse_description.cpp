#include "explore/browse_description.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "explore/optimizer_kind.hpp"
#include "explore/sampler_kind.hpp"

namespace bodyline::explore {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinite numbers.
Json limit(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json columns_json(const StoreReader& store) {
  Json columns = Json::array();
  for (const Column& column : store.space().columns()) {
    columns.push_back({{"name", column.name},
                       {"unit", column.unit},
                       {"kind", column_kind_name(column.kind)},
                       {"metric", false},
                       {"least", limit(column.lower)},
                       {"most", limit(column.upper)},
                       {"start", limit(column.start)}});
  }
  for (const MetricSpec& metric : store.study().metrics) {
    Constraint range;
    for (const Constraint& constraint : store.study().constraints) {
      if (constraint.metric == metric.name) range = constraint;
    }
    columns.push_back({{"name", metric.name},
                       {"unit", metric_unit(metric.kind)},
                       {"kind", metric_name(metric.kind)},
                       {"metric", true},
                       {"least", limit(range.least)},
                       {"most", limit(range.most)}});
  }
  return columns;
}

Json faces_json(const StoreReader& store) {
  Json faces = Json::array();
  for (const model::Face& face : store.space().context()->plan.body_faces) {
    faces.push_back({{"name", face.name},
                     {"degreeU", face.degree_u},
                     {"degreeV", face.degree_v},
                     {"blend", face.blend >= 0},
                     {"central", face.central},
                     {"inward", face.inward}});
  }
  return faces;
}

Json objectives_json(const StoreReader& store, const std::vector<StoreObjective>& objectives) {
  Json list = Json::array();
  for (const StoreObjective& objective : objectives) {
    const int first = objective.column.is_metric ? store.space().column_count() : 0;
    list.push_back({{"column", first + objective.column.index}, {"minimize", objective.minimize}});
  }
  return list;
}

// The models' files come after the study among the inputs.
Json models_json(const Study& study) {
  Json models = Json::array();
  for (std::size_t k = 0; k < study.models.size(); ++k)
    models.push_back(study.inputs.at(k + 1).name);
  return models;
}

// The same text for a JSON reader, and without an end of the element around it.
std::string within_script(const std::string& json) {
  std::string text;
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

}  // namespace

std::string browse_description(const StoreReader& store,
                               const std::vector<StoreObjective>& objectives,
                               const BrowseRows& rows, const BrowseBodies& bodies) {
  const Study& study = store.study();
  Json statuses = Json::array();
  for (int k = 0; k < status_count; ++k) statuses.push_back(status_name(VariantStatus(k)));
  const std::string method =
      study.optimizer ? optimizer_name(study.optimizer->kind) : sampler_name(study.sampler.kind);
  const Json description{{"study", study.name},
                         {"note", study.note},
                         {"store", store.path().filename().string()},
                         {"version", store.header().version},
                         {"method", method},
                         {"stored", store.rows()},
                         {"planned", store.header().planned},
                         {"shown", rows.count()},
                         {"columns", columns_json(store)},
                         {"statuses", statuses},
                         {"causes", store.header().causes},
                         {"objectives", objectives_json(store, objectives)},
                         {"base", study.base == BaseKind::model    ? "model"
                                  : study.base == BaseKind::choice ? "choice"
                                                                   : "blend"},
                         {"models", models_json(study)},
                         {"faces", faces_json(store)},
                         {"bodyPoints", bodies.points},
                         {"bodiesKept", study.keep.nets}};
  return within_script(description.dump(-1, ' ', true));
}

}  // namespace bodyline::explore
