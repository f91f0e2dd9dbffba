#include "cli/explore_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "explore/thread_count.hpp"

namespace bodyline::cli {
namespace {

using explore::RunProgress;
using explore::Study;
using explore::VariantStatus;
using Json = nlohmann::ordered_json;

std::string duration_text(double seconds) {
  if (seconds < 1.0) return fmt::format("{:.2f} s", seconds);
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string size_text(double bytes) {
  constexpr std::array<const char*, 5> units{"bytes", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1000.0 && unit + 1 < units.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

double rate_of(const RunProgress& run) {
  return run.seconds > 0.0 ? double(run.measured) / run.seconds : 0.0;
}

// ", valid 120, folded 3"
std::string status_text(const RunProgress& run) {
  std::string text;
  for (int k = 0; k < explore::status_count; ++k) {
    if (run.by_status[k] > 0)
      text += fmt::format(", {} {}", explore::status_name(VariantStatus(k)), run.by_status[k]);
  }
  return text;
}

double seconds_for_all(const explore::StudyEstimate& estimate, int threads) {
  return double(estimate.variants) * estimate.seconds_per_variant / explore::thread_count(threads);
}

}  // namespace

std::string progress_text(const Study& study, const RunProgress& run) {
  const double rate = rate_of(run);
  std::string text = run.note.empty() ? "" : run.note + ", ";
  text += fmt::format("{:.0f}/s", rate);
  if (rate > 0.0)
    text += fmt::format(", {} left", duration_text(double(run.planned - run.done) / rate));
  text += status_text(run);
  if (run.best)
    text +=
        fmt::format(", least {} {:.5g} ({})", study.metrics.front().name, *run.best, run.best_row);
  return text;
}

std::string result_text(const Study& study, const RunProgress& run, const std::string& path) {
  std::string text =
      fmt::format("{} of {} variants measured in {}, {:.0f}/s{}\n", run.measured, run.planned,
                  duration_text(run.seconds), rate_of(run), status_text(run));
  if (run.evaluations > 0)
    text += fmt::format("{} evaluations of all goals with their gradients\n", run.evaluations);
  if (run.best) {
    text += fmt::format("least {} of a valid variant: {:.6g}, variant {}\n",
                        study.metrics.front().name, *run.best, run.best_row);
  }
  text += "store: " + path + "\n";
  if (run.done < run.planned)
    text += fmt::format("{} variants are left; --resume goes on\n", run.planned - run.done);
  return text;
}

Json result_json(const Study& study, const RunProgress& run, const std::string& path) {
  Json by_status;
  for (int k = 0; k < explore::status_count; ++k)
    by_status[explore::status_name(VariantStatus(k))] = run.by_status[k];
  Json best = nullptr;
  if (run.best)
    best = {{"metric", study.metrics.front().name}, {"value", *run.best}, {"id", run.best_row}};
  return {{"store", path},
          {"planned", run.planned},
          {"done", run.done},
          {"measured", run.measured},
          {"seconds", run.seconds},
          {"variants_per_second", rate_of(run)},
          {"evaluations", run.evaluations},
          {"by_status", by_status},
          {"best", best}};
}

std::string estimate_text(const explore::VariantPlan& plan, const explore::StudyEstimate& estimate,
                          int threads) {
  const Study& study = plan.study;
  std::string text = fmt::format(
      "{}: {} variants of {} variables, {} metrics\n"
      "about {} on {} threads ({:.3g} us each), {} on the disk\n\n{:<12}",
      study.name, estimate.variants, plan.space.column_count(), study.metrics.size(),
      duration_text(seconds_for_all(estimate, threads)), explore::thread_count(threads),
      1e6 * estimate.seconds_per_variant,
      size_text(estimate.bytes_per_variant * double(estimate.variants)), "tried");
  for (const explore::MetricSpec& metric : study.metrics)
    text += fmt::format(" {:>14}", metric.name);
  const explore::VariantRows& rows = estimate.tried;
  for (int row = 0; row < rows.count; ++row) {
    text += fmt::format("\n{:<12}", explore::status_name(VariantStatus(rows.status[row])));
    for (std::size_t k = 0; k < study.metrics.size(); ++k)
      text += fmt::format(" {:>14.6g}", rows.metrics[std::size_t(row) * study.metrics.size() + k]);
    if (rows.cause[row] != explore::no_cause) text += "  " + plan.causes[rows.cause[row]];
  }
  return text + "\n";
}

Json estimate_json(const explore::VariantPlan& plan, const explore::StudyEstimate& estimate,
                   int threads) {
  Json tried = Json::array();
  const explore::VariantRows& rows = estimate.tried;
  for (int row = 0; row < rows.count; ++row) {
    Json variant{{"status", explore::status_name(VariantStatus(rows.status[row]))},
                 {"cause", plan.causes[rows.cause[row]]}};
    for (std::size_t k = 0; k < plan.study.metrics.size(); ++k) {
      variant["metrics"][plan.study.metrics[k].name] =
          rows.metrics[std::size_t(row) * plan.study.metrics.size() + k];
    }
    tried.push_back(variant);
  }
  return {{"study", plan.study.name},
          {"variants", estimate.variants},
          {"variables", plan.space.column_count()},
          {"metrics", plan.study.metrics.size()},
          {"seconds", seconds_for_all(estimate, threads)},
          {"seconds_per_variant", estimate.seconds_per_variant},
          {"bytes", estimate.bytes_per_variant * double(estimate.variants)},
          {"tried", tried}};
}

}  // namespace bodyline::cli
