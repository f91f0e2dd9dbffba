#include "cli/deviation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/pose_option.hpp"

namespace bodyline::cli {

using Json = nlohmann::ordered_json;

Json pose_json(const model::Pose& pose) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    rotation.push_back({pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2)});
  }
  const Eigen::Vector3d& move = pose.translation;
  return {{"rotation", rotation},
          {"translation_mm", {move.x(), move.y(), move.z()}},
          {"scale", pose.scale}};
}

namespace {

const char* end_name(optimize::MissingEnd end) {
  if (end == optimize::MissingEnd::both) return "both";
  return end == optimize::MissingEnd::front ? "front" : "rear";
}

}  // namespace

Json alignment_json(const PlacedScan& placed) {
  const optimize::AlignResult& found = placed.alignment;
  const bool left = found.missing == optimize::MissingSide::left;
  Json side, end;  // null when all is there
  if (found.missing != optimize::MissingSide::none) side = left ? "left" : "right";
  if (found.missing_end != optimize::MissingEnd::none) end = end_name(found.missing_end);
  return {{"given", placed.pose_given},
          {"unit", found.unit},
          {"unit_given", placed.unit_given},
          {"option", pose_text(placed.pose)},
          {"fit", found.fit},
          {"doubt", found.doubt},
          {"coverage", found.coverage},
          {"symmetry_mm", found.symmetry_mm},
          {"missing_side", side},
          {"missing_end", end},
          {"doubtful", found.pose_is_doubtful}};
}

Json distances_json(const optimize::Distances& distances) {
  return {{"median", distances.median},
          {"p90", distances.p90},
          {"p99", distances.p99},
          {"trimmed_rms", distances.trimmed_rms}};
}

Json faces_json(const optimize::Deviation& deviation) {
  Json rows = Json::array();
  for (const optimize::FaceDeviation& face : deviation.faces) {
    rows.push_back({{"name", face.name},
                    {"points", face.points},
                    {"seen", face.seen},
                    {"mean_mm", face.mean},
                    {"distance_mm", distances_json(face.distances)}});
  }
  return rows;
}

std::string unseen_words(const optimize::Deviation& deviation, const std::string& held_by) {
  if (deviation.unseen_patches.empty()) return "";
  const optimize::DeviationOptions options;
  return fmt::format(
      "Hardly seen by the scan (under {:.0f} % of the patch has points within {:g} mm){}: {}\n",
      100.0 * options.least_seen, options.near, held_by, fmt::join(deviation.unseen_patches, ", "));
}

std::string deviation_table(const optimize::Deviation& deviation) {
  std::string text = fmt::format("{:<44} {:>8} {:>6} {:>8} {:>8} {:>8} {:>8}\n", "face", "points",
                                 "seen", "median", "90 %", "99 %", "rms");
  const auto row = [&](const std::string& name, std::size_t points, const std::string& seen,
                       const optimize::Distances& d) {
    text += fmt::format("{:<44} {:>8} {:>6} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f}\n", name, points,
                        seen, d.median, d.p90, d.p99, d.trimmed_rms);
  };
  std::vector<const optimize::FaceDeviation*> order;
  for (const optimize::FaceDeviation& face : deviation.faces) {
    if (face.points > 0) order.push_back(&face);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return a->distances.median > b->distances.median;
  });
  for (const optimize::FaceDeviation* face : order) {
    row(face->name, face->points, fmt::format("{:.0f} %", 100.0 * face->seen), face->distances);
  }
  row("all", deviation.matches.size(), "", deviation.distances);
  return text +
         "Distances in mm, without sign, outliers too; rms is of the nearest 90 % of the points.\n";
}

}  // namespace bodyline::cli
