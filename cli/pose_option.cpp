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

// Scans in coordinates of a country lie up to some 1e10 mm from the origin.
constexpr double most_degrees = 360.0, most_mm = 1e12, least_scale = 1e-6, most_scale = 1e6;

// So near a scan in mm was in the coordinates of a model already, though not exactly of this one.
constexpr double near_degrees = 5.0, near_mm = 1000.0;

Eigen::Matrix3d turn(double degrees, int axis) {
  return Eigen::AngleAxisd(degrees * degree, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

void check_range(const std::array<double, numbers_of_a_pose>& numbers) {
  const auto refuse = [](const std::string& what, double least, double most, double number) {
    throw std::invalid_argument(
        fmt::format("{} of a pose is from {:g} to {:g}, not {:g}", what, least, most, number));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(numbers[k]) > most_degrees)
      refuse("an angle, in degrees,", -most_degrees, most_degrees, numbers[k]);
    if (std::abs(numbers[3 + k]) > most_mm)
      refuse("a move, in mm,", -most_mm, most_mm, numbers[3 + k]);
  }
  if (numbers[6] < least_scale || numbers[6] > most_scale)
    refuse("the scale, mm per unit of the scan,", least_scale, most_scale, numbers[6]);
}

// Turns about x, y and z in degrees; those of a small rotation are small.
Eigen::Vector3d turns_of(const Eigen::Matrix3d& r) {
  const double about_z = std::atan2(r(1, 0), r(0, 0));
  const double s = std::sin(about_z), c = std::cos(about_z);
  const double about_y = std::atan2(-r(2, 0), c * r(0, 0) + s * r(1, 0));
  const double about_x = std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1));
  return Eigen::Vector3d(about_x, about_y, about_z) / degree;
}

// Adding 0 turns -0 into 0.
std::string joined(const Eigen::Vector3d& turns, const Eigen::Vector3d& move) {
  return fmt::format("{:.15g},{:.15g},{:.15g},{:.15g},{:.15g},{:.15g}", turns.x() + 0.0,
                     turns.y() + 0.0, turns.z() + 0.0, move.x() + 0.0, move.y() + 0.0,
                     move.z() + 0.0);
}

Eigen::Vector3d rounded(const Eigen::Vector3d& numbers, double step) {
  return (numbers / step).array().round().matrix() * step;
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
  check_range(numbers);
  model::Pose pose;
  pose.rotation = turn(numbers[2], 2) * turn(numbers[1], 1) * turn(numbers[0], 0);
  pose.translation = {numbers[3], numbers[4], numbers[5]};
  pose.scale = numbers[6];
  return pose;
}

std::string pose_text(const model::Pose& pose) {
  return fmt::format("{},{:.15g}", joined(turns_of(pose.rotation), pose.translation), pose.scale);
}

std::string moved_frame_words(const model::Pose& pose) {
  // A ten-thousandth of a degree moves a point of a car by less than 0.01 mm.
  const std::string option = fmt::format(
      "{},{:.9g}", joined(rounded(turns_of(pose.rotation), 1e-4), rounded(pose.translation, 1e-3)),
      pose.scale);
  const double angle = Eigen::AngleAxisd(pose.rotation).angle() / degree;
  const Eigen::Vector3d& move = pose.translation;
  if (pose.scale != 1.0 || angle > near_degrees || move.norm() > near_mm) {
    return fmt::format(
        "The model has coordinates of its own: --pose {} takes the scan there again.", option);
  }
  return fmt::format(
      "The scan lay nearly in the model's coordinates; it was moved by {:.1f}, {:.1f}, {:.1f} mm "
      "along x, y, z and turned by {:.2f} degrees: --pose {} does so again, --pose none leaves it "
      "where it lies.",
      move.x() + 0.0, move.y() + 0.0, move.z() + 0.0, angle, option);
}

}  // namespace bodyline::cli
