#include "explore/study_tables.hpp"

#include <optional>
#include <stdexcept>

#include "io/model_file_lookup.hpp"
#include "io/model_file_names.hpp"
#include "io/parse_views.hpp"

namespace bodyline::explore {
namespace {

using io::FileTable;

constexpr double largest_number = 1e9;
constexpr int most_scan_points = 1'000'000;

struct RangeKey {
  const char* name;
  RangeKind kind;
};
constexpr RangeKey range_keys[] = {{"range", RangeKind::value},
                                   {"offset", RangeKind::offset},
                                   {"factor", RangeKind::factor},
                                   {"width", RangeKind::width}};

void read_range(const FileTable& table, VariableGroup& group) {
  for (const RangeKey& key : range_keys) {
    if (!table.has(key.name)) continue;
    if (group.kind != RangeKind::bounds) {
      table.fail(key.name,
                 "is a second range; give one of \"range\", \"offset\", \"factor\" and \"width\".");
    }
    group.kind = key.kind;
    const std::vector<double> ends = table.numbers(key.name, {2, 2}, largest_number);
    group.range = {ends[0], ends[1]};
    if (!(ends[0] < ends[1])) table.fail(key.name, "must rise: its first number is the least.");
    if (key.kind == RangeKind::width && !(ends[0] > 0.0 && ends[1] < 1.0))
      table.fail(key.name, "must lie between 0 and 1: it is a part of the patch.");
  }
}

void read_link(const FileTable& table, VariableGroup& group) {
  group.linked = table.flag_or("linked", false);
  if (group.linked && group.kind != RangeKind::offset && group.kind != RangeKind::factor)
    table.fail("linked", "needs the range \"offset\" or \"factor\", by which all move together.");
  if (!table.has("weights")) return;
  if (!group.linked || group.kind != RangeKind::offset)
    table.fail("weights", "belongs to a linked group with the range \"offset\".");
  const std::size_t count = group.vary.size();
  group.weights = table.numbers("weights", {count, count}, largest_number);
}

VariableGroup read_group(const std::string& name, const FileTable& table) {
  table.allow_only({"vary", "range", "offset", "factor", "width", "linked", "weights"},
                   "a group of variables");
  VariableGroup group;
  group.name = name;
  group.vary = table.texts("vary", {1, io::most_entries});
  read_range(table, group);
  read_link(table, group);
  return group;
}

model::Stage stage_of(const FileTable& table) {
  const std::string name = table.text_or("stage", "body");
  for (const model::Stage stage : {model::Stage::base, model::Stage::kept, model::Stage::body}) {
    if (name == model::stage_name(stage)) return stage;
  }
  table.fail("stage", "is " + io::in_quotes(name) + "; the stages are base, kept and body.");
}

MetricKind kind_of(const FileTable& table, const std::string& otherwise) {
  try {
    return metric_kind(table.text_or("kind", otherwise));
  } catch (const std::invalid_argument& error) {
    table.fail(table.has("kind") ? "kind" : "", std::string(error.what()) + ".");
  }
}

std::string views_of(const FileTable& table) {
  const std::string views = table.text("views");
  try {
    io::parse_views(views);
  } catch (const std::invalid_argument& error) {
    table.fail("views", error.what());
  }
  return views;
}

MetricSpec read_metric(const std::string& name, const FileTable& table) {
  table.allow_only({"kind", "stage", "faces", "face", "file", "points", "posed", "views"},
                   "a metric");
  MetricSpec metric;
  metric.name = name;
  metric.kind = kind_of(table, name);
  const bool energy = is_term(metric.kind) && metric.kind != MetricKind::closeness;
  const auto belongs = [&](const char* key, bool allowed, const std::string& to) {
    if (table.has(key) && !allowed) table.fail(key, "belongs to " + to + " only.");
    return table.has(key);
  };
  if (belongs("stage", energy, "bending, variation, area and fold")) metric.stage = stage_of(table);
  if (belongs("faces", energy, "bending, variation, area and fold"))
    metric.faces = table.texts("faces", {1, io::most_entries});
  if (belongs("face", metric.kind == MetricKind::rake, "a rake"))
    metric.faces = {table.text("face")};
  if (belongs("file", metric.kind == MetricKind::scan, "a scan")) metric.scan = table.text("file");
  if (belongs("points", metric.kind == MetricKind::scan, "a scan"))
    metric.points = static_cast<int>(table.whole("points", 1, most_scan_points));
  if (belongs("posed", metric.kind == MetricKind::scan, "a scan"))
    metric.posed = table.flag_or("posed", false);
  if (belongs("views", metric.kind == MetricKind::outline, "an outline"))
    metric.views = views_of(table);
  if (metric.kind == MetricKind::outline && metric.views.empty())
    table.fail("views", "is missing.");
  if (metric.kind == MetricKind::rake && metric.faces.empty()) table.fail("face", "is missing.");
  if (metric.kind == MetricKind::scan && metric.scan.empty()) table.fail("file", "is missing.");
  return metric;
}

}  // namespace

void read_variables(const FileTable& root, Study& study) {
  for (const auto& [name, table] : io::entries(root, "variables"))
    study.variables.push_back(read_group(name, table));
}

void read_metrics(const FileTable& root, Study& study) {
  for (const auto& [name, table] : io::entries(root, "metrics"))
    study.metrics.push_back(read_metric(name, table));
  if (study.metrics.empty())
    root.fail("metrics", "is empty or missing; a study measures something.");
}

void read_constraints(const FileTable& root, Study& study) {
  for (const auto& [name, table] : io::entries(root, "constraints")) {
    table.allow_only({"least", "most"}, "a constraint");
    io::index_of(study.metrics, name, table, "", "metric");
    Constraint constraint;
    constraint.metric = name;
    if (table.has("least")) constraint.least = table.real("least", largest_number);
    if (table.has("most")) constraint.most = table.real("most", largest_number);
    if (!table.has("least") && !table.has("most"))
      table.fail("", "needs \"least\", \"most\" or both.");
    if (!(constraint.least <= constraint.most)) table.fail("most", "is below \"least\".");
    study.constraints.push_back(constraint);
  }
}

}  // namespace bodyline::explore
