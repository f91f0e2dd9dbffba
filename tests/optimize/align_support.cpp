#include "tests/optimize/align_support.hpp"

#include <stdexcept>

#include "io/read_model.hpp"
#include "tests/optimize/scan_samples.hpp"

namespace bodyline::optimize {

model::Model car(const std::string& name) {
  return io::read_model(std::string(BODYLINE_SOURCE_DIR) + "/cars/" + name + ".toml");
}

model::Pose drawn_pose(unsigned seed) {
  SampleDraw draw(seed);
  model::Pose pose;
  pose.rotation = draw.rotation();
  pose.translation = 5000.0 * draw.normal_vector();
  pose.scale = unit_mm[seed % unit_mm.size()];
  return pose;
}

std::string refusal(const model::Scan& scan, const AlignOptions& options) {
  try {
    align_scan(scan, car("template"), options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace bodyline::optimize
