#include "cli/fit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/deviation_text.hpp"

namespace bodyline::cli {
namespace {

// Less is the scatter of a scan's points and of rims.
constexpr double worth_a_warning = 10.0;  // mm

nlohmann::ordered_json arches_json(const std::vector<optimize::ArchGap>& arches) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const optimize::ArchGap& arch : arches) {
    rows.push_back(
        {{"arch", arch.front ? "front" : "rear"}, {"part", arch.part}, {"gap_mm", arch.gap}});
  }
  return rows;
}

nlohmann::ordered_json rounds_json(const optimize::FitResult& result) {
  nlohmann::ordered_json rounds = nlohmann::ordered_json::array();
  for (const optimize::FitProgress& round : result.history)
    rounds.push_back({{"phase", round.phase},
                      {"round", round.round},
                      {"median_mm", round.distance},
                      {"seconds", round.seconds}});
  return rounds;
}

}  // namespace

bool has_findings(const FittedCar& car) {
  return car.result.status == optimize::Status::failed || !car.bounds_kept.all() ||
         !car.result.folded_faces.empty();
}

std::vector<std::string> arch_warnings(const std::vector<optimize::ArchGap>& arches) {
  std::vector<std::string> words;
  for (const optimize::ArchGap& arch : arches) {
    if (std::abs(arch.gap) <= worth_a_warning) continue;
    words.push_back(fmt::format("wheel arch {}, {}: rim {:.0f} mm {}",
                                arch.front ? "front" : "rear", arch.part, std::abs(arch.gap),
                                arch.gap > 0.0 ? "short of the scan" : "beyond the scan"));
  }
  return words;
}

std::string hidden_arches(const model::Model& model, const std::vector<optimize::ArchGap>& arches) {
  std::string parts;
  for (const bool front : {true, false}) {
    if ((front ? model.front_arch : model.rear_arch).curves.empty()) continue;
    for (const char* const part : {"rear", "top", "front"}) {
      const bool told = std::any_of(arches.begin(), arches.end(), [&](const auto& arch) {
        return arch.front == front && arch.part == part;
      });
      if (!told)
        parts += fmt::format("{}{}, {}", parts.empty() ? "" : "; ", front ? "front" : "rear", part);
    }
  }
  if (parts.empty()) return "";
  return "wheel arches where the scan does not tell its end (a wheel, a hole, few points): " +
         parts;
}

nlohmann::ordered_json fit_json(const FittedCar& car) {
  nlohmann::ordered_json json{{"status", optimize::status_words(car.result.status)}};
  if (car.deviation) {
    json["scan"] = car.scan->words;
    json["pose"] = pose_json(car.scan->pose);
    json["alignment"] = alignment_json(*car.scan);
    json["distance_mm"] = distances_json(car.deviation->distances);
    json["unseen_patches"] = car.deviation->unseen_patches;
    json["wheel_arches"] = arches_json(car.arches);
  }
  if (!car.drawn.words.empty()) json["drawings"] = car.drawn.words;
  json["outline_mm"] = outlines_json(car.kept);
  json["feature_mm"] = features_json(car.kept);
  json["folded"] = car.result.folded_faces;
  json["dimensions"] = dimensions_json(car.bounds, car.bounds_kept);
  json["hard_points"] = hard_points_json(car.bounds, car.bounds_kept);
  if (car.deviation) json["faces"] = faces_json(*car.deviation);
  json["rounds"] = rounds_json(car.result);
  json["seconds"] = car.seconds;
  return json;
}

std::string fit_text(const FittedCar& car) {
  std::string text;
  if (car.scan) text += car.scan->words + "\n";
  if (!car.drawn.words.empty()) text += car.drawn.words + "\n";
  text += optimize::status_words(car.result.status) + "\n\n";
  if (car.deviation) {
    text += deviation_table(*car.deviation);
    const bool whole = car.scan->alignment.missing_end == optimize::MissingEnd::none;
    text += unseen_words(*car.deviation, whole ? ", held by fairness alone"
                                               : ", held by fairness and the start model");
  }
  for (const std::string& words : arch_warnings(car.arches)) text += words + "\n";
  if (const std::string words = car.deviation ? hidden_arches(car.result.model, car.arches) : "";
      !words.empty())
    text += words + "\n";
  text += drawn_text(car.kept);
  text += bounds_text(car.bounds, car.bounds_kept);
  for (const std::string& face : car.result.folded_faces) text += "still folded: " + face + "\n";
  return text + fmt::format("{:.1f} s\n", car.seconds);
}

}  // namespace bodyline::cli
