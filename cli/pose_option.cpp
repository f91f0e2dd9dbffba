#include "cli/pose_option.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "io/scan_words.hpp"

namespace bodyline::cli {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::size_t numbers_of_a_pose = 7;

Eigen::Matrix3d turn(double degrees, int axis) {
  return Eigen::AngleAxisd(degrees * degree, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

}  // namespace

model::Pose pose_from_text(const std::string& text) {
  std::array<double, numbers_of_a_pose> numbers{};
  std::string_view rest = text;
  std::size_t count = 0;
  for (auto word = io::next_word(rest); !word.empty(); word = io::next_word(rest), ++count) {
    if (count == numbers.size()) continue;
    if (!io::number_from_word(word, numbers[count]) || !std::isfinite(numbers[count])) {
      throw std::invalid_argument(fmt::format("'{}' in the pose is not a finite number", word));
    }
  }
  if (count != numbers.size()) {
    throw std::invalid_argument(fmt::format(
        "the pose '{}' has {} numbers; it takes seven, rx,ry,rz,tx,ty,tz,scale", text, count));
  }
  if (numbers[6] <= 0.0) throw std::invalid_argument("the scale of a pose must be greater than 0");
  model::Pose pose;
  pose.rotation = turn(numbers[2], 2) * turn(numbers[1], 1) * turn(numbers[0], 0);
  pose.translation = {numbers[3], numbers[4], numbers[5]};
  pose.scale = numbers[6];
  return pose;
}

std::string pose_text(const model::Pose& pose) {
  // Adding 0 turns -0 into 0.
  const Eigen::Vector3d turns =
      pose.rotation.eulerAngles(2, 1, 0) / degree + Eigen::Vector3d::Zero();
  const Eigen::Vector3d& move = pose.translation;
  return fmt::format("{:.15g},{:.15g},{:.15g},{:.15g},{:.15g},{:.15g},{:.15g}", turns[2], turns[1],
                     turns[0], move.x(), move.y(), move.z(), pose.scale);
}

}  // namespace bodyline::cli
