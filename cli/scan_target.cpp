#include "cli/scan_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cli/number_check.hpp"
#include "cli/pose_option.hpp"
#include "cli/progress.hpp"
#include "io/input_error.hpp"
#include "optimize/orient_normals.hpp"
#include "optimize/scan_above.hpp"

namespace bodyline::cli {

void add_scan_target(CLI::App& command, ScanTarget& target) {
  command
      .add_option("SCAN", target.path,
                  fmt::format("Scan: {}", fmt::join(io::scan_extensions(), ", ")))
      ->required();
  command
      .add_option(
          "--pose", target.pose,
          "Pose of the scan: rx,ry,rz,tx,ty,tz,scale in degrees and mm, or none; found when "
          "left out")
      ->type_name("POSE");
  CLI::Option* const pose = command.get_option("--pose");
  command.add_option("--unit", target.unit_mm, "mm per unit of the scan; guessed when left out")
      ->type_name("MM")
      ->check(positive_number())
      ->excludes(pose);
  command
      .add_option("--points", target.most_points,
                  "Most points of the scan that are measured; the search uses up to 60000")
      ->type_name("N")
      ->check(CLI::Range(std::size_t(1000), std::size_t(10'000'000)))
      ->capture_default_str();
}

PlacedScan place_scan(Context& context, const ScanTarget& target, const model::Model& model) {
  io::ScanFile file;
  {
    const Progress progress(context, "reading " + target.path);
    io::ReadScanOptions reading;
    reading.most_points = std::max(reading.most_points, target.most_points);
    reading.mesh_points = target.most_points;
    file = io::read_scan(target.path, reading);
  }
  PlacedScan placed;
  placed.words = fmt::format("{}: {}, {} {}", target.path, file.format, file.points_in_file,
                             file.mesh ? "vertices" : "points");
  if (file.dropped > 0) placed.words += fmt::format(", {} of them not usable", file.dropped);
  placed.words += ".";
  optimize::AlignOptions options;
  options.unit_mm = target.unit_mm;
  options.reference = target.reference;
  if (target.pose == "none") {
    options.pose = model::Pose{};
  } else if (!target.pose.empty()) {
    options.pose = pose_from_text(target.pose);
  }
  const Progress progress(context, "finding the pose");
  try {
    const optimize::AlignResult aligned = optimize::align_scan(file.scan, model, options);
    placed.words += "\n" + aligned.words;
    placed.pose = aligned.pose;
    placed.alignment = aligned;
    placed.pose_given = options.pose.has_value();
    placed.unit_given = placed.pose_given || target.unit_mm > 0.0;
    if (!placed.pose_given) placed.words += "\n" + moved_frame_words(placed.pose);
    const model::Scan car = optimize::scan_above(file.scan, aligned.pose, aligned.floor_mm);
    placed.scan = optimize::oriented_scan(car, aligned.pose, model, target.most_points);
    placed.fitted = placed.scan;
    const model::Scan& beyond = aligned.beyond_end;
    placed.fitted.points.insert(placed.fitted.points.end(), beyond.points.begin(),
                                beyond.points.end());
    placed.fitted.normals.insert(placed.fitted.normals.end(), beyond.normals.begin(),
                                 beyond.normals.end());
  } catch (const std::invalid_argument& error) {
    throw io::InputError(target.path, 0, "",
                         error.what() + std::string("; --unit and --pose say how it lies."));
  }
  return placed;
}

}  // namespace bodyline::cli
