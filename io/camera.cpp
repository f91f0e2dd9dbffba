#include "io/camera.hpp"

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace bodyline::io {
namespace {

// Distance of the eye in diagonals of the body: a field of view of about 17 degrees.
constexpr double long_lens = 3.2;

std::vector<std::pair<std::string, View>> named_views() {
  return {
      {"iso", View{}},
      {"front", View{0.0, 0.0, false}},
      {"rear", View{180.0, 0.0, false}},
      {"side", View{90.0, 0.0, false}},
      {"top", View{90.0, 90.0, false}},
  };
}

std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Exact at multiples of 90 degrees, so that symmetric views are symmetric.
double cosine(double degrees) {
  const double quarter = std::fmod(std::abs(degrees), 360.0) / 90.0;
  if (quarter == 1.0 || quarter == 3.0) return 0.0;
  return std::cos(degrees * std::numbers::pi / 180.0);
}
double sine(double degrees) { return cosine(degrees - 90.0); }

}  // namespace

View view_from_name(const std::string& name) {
  for (const auto& [known, view] : named_views()) {
    if (known == name) return view;
  }
  const std::size_t comma = name.find(',');
  if (comma != std::string::npos) {
    const auto azimuth = number(name.substr(0, comma)), elevation = number(name.substr(comma + 1));
    if (azimuth && elevation && std::abs(*elevation) <= 90.0) {
      return View{*azimuth, *elevation, true};
    }
  }
  throw std::invalid_argument("unknown view '" + name +
                              "': give iso, front, rear, side, top or AZ,EL in degrees with EL "
                              "from -90 to 90, for example 35,15");
}

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const auto& [name, view] : named_views()) names.push_back(name);
  return names;
}

Camera::Camera(const View& view, const std::vector<Eigen::Vector3d>& points, const Frame& frame)
    : perspective_(view.perspective) {
  if (points.empty()) throw std::invalid_argument("a camera needs at least one point to look at");
  const double ca = cosine(view.azimuth), sa = sine(view.azimuth);
  const double ce = cosine(view.elevation), se = sine(view.elevation);
  towards_ = {-ca * ce, -sa * ce, se};
  right_ = {sa, -ca, 0.0};
  up_ = towards_.cross(right_);

  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const double diagonal = std::max(box.diagonal().norm(), 1e-6);
  eye_ = box.center() + long_lens * diagonal * towards_;

  Eigen::AlignedBox2d seen;
  for (const Eigen::Vector3d& point : points) seen.extend(plane_position(point));
  const Eigen::Vector2d extent = seen.diagonal();
  scale_ = std::min((frame.right - frame.left) / std::max(extent.x(), 1e-9),
                    (frame.bottom - frame.top) / std::max(extent.y(), 1e-9));
  plane_centre_ = seen.center();
  centre_ = {0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom)};
}

Eigen::Vector2d Camera::plane_position(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d from_eye = point - eye_;
  const double depth = perspective_ ? -from_eye.dot(towards_) : 1.0;
  return {from_eye.dot(right_) / depth, from_eye.dot(up_) / depth};
}

Eigen::Vector2d Camera::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d p = scale_ * (plane_position(point) - plane_centre_);
  return {centre_.x() + p.x(), centre_.y() - p.y()};
}

Ray Camera::ray(double x, double y) const {
  const double a = plane_centre_.x() + (x - centre_.x()) / scale_;
  const double b = plane_centre_.y() - (y - centre_.y()) / scale_;
  const Eigen::Vector3d offset = a * right_ + b * up_;
  if (perspective_) return {eye_, (offset - towards_).normalized()};
  return {eye_ + offset, -towards_};
}

double Camera::pixel_size(double distance) const {
  return (perspective_ ? distance : 1.0) / scale_;
}

}  // namespace bodyline::io
