#include "cli/deviation_text.hpp"

#include <fmt/format.h>

#include <algorithm>

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

std::string deviation_table(const optimize::Deviation& deviation) {
  std::string text = fmt::format("{:<44} {:>8} {:>6} {:>8} {:>8} {:>8} {:>8}\n", "face", "points",
                                 "seen", "mean", "median", "90 %", "99 %");
  const auto row = [&](const std::string& name, std::size_t points, const std::string& seen,
                       const std::string& mean, const optimize::Distances& d) {
    text += fmt::format("{:<44} {:>8} {:>6} {:>8} {:>8.2f} {:>8.2f} {:>8.2f}\n", name, points, seen,
                        mean, d.median, d.p90, d.p99);
  };
  std::vector<const optimize::FaceDeviation*> order;
  for (const optimize::FaceDeviation& face : deviation.faces) {
    if (face.points > 0) order.push_back(&face);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return a->distances.median > b->distances.median;
  });
  for (const optimize::FaceDeviation* face : order) {
    row(face->name, face->points, fmt::format("{:.0f} %", 100.0 * face->seen),
        fmt::format("{:+.2f}", face->mean), face->distances);
  }
  row("all", deviation.matches.size(), "", "", deviation.distances);
  return text +
         "Distances in mm, outliers too; the mean is positive where the scan lies outside of the "
         "body.\n";
}

}  // namespace bodyline::cli
