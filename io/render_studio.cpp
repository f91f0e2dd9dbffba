#include "io/render_studio.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::io {
namespace {

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// 1 inside [-half, half], 0 outside, with an edge of the given width.
double band(double x, double half, double edge) {
  return 1.0 - smooth_step(half - 0.5 * edge, half + 0.5 * edge, std::abs(x));
}

// A rectangle of light on the plane at distance 1 along an axis, seen in direction (along, across,
// height).
double panel(double along, double across, double height, double half_across, double low,
             double high, double edge) {
  if (along <= 1e-3) return 0.0;
  const double middle = 0.5 * (low + high);
  return band(across / along, half_across, 2.0 * edge) *
         band(height / along - middle, 0.5 * (high - low), edge);
}

double sky(double z, double blur) {
  const double horizon = 0.30, zenith = 0.95, width = 0.16 + 0.5 * blur;
  const double above = horizon + (zenith - horizon) * smooth_step(-0.02, 0.75, z);
  const double floor = 0.78;
  return floor + (above - floor) * smooth_step(-width, 0.25 * width, z);
}

Color tone_mapped(const Color& light) {
  constexpr float white = 3.2f;  // what just becomes white
  return (light * (1.0f + light / (white * white)) / (1.0f + light)).min(1.0f) * 1.22f;
}

}  // namespace

Color backdrop(double from_top) {
  const double t = smooth_step(0.0, 1.0, from_top);
  return color_from_oklch(0.895 + 0.075 * t, 0.004, 260.0);
}

Color studio_light(const Eigen::Vector3d& d, double blur) {
  const double edge = 0.12 + 1.2 * blur, lamps = 1.0 / (1.0 + 1.2 * blur);
  double light = sky(d.z(), blur);
  light +=
      2.1 * lamps * panel(d.z(), d.y(), d.x() + 0.15 * d.z(), 0.42, -1.9, 1.9, edge);  // overhead
  light += 0.8 * lamps * panel(std::abs(d.y()), d.x(), d.z(), 2.4, 0.38, 0.72, edge);  // both sides
  light += 0.6 * lamps * panel(-d.x(), d.y(), d.z(), 1.0, 0.42, 0.80, edge);           // in front
  light += 0.8 * lamps * panel(d.x(), d.y(), d.z(), 1.3, 0.25, 0.60, edge);  // behind: the rim
  const float l = static_cast<float>(light);
  return {0.985f * l, 0.995f * l, 1.02f * l};
}

Color paint(const ShadedPoint& point, const Color& base, const Occlusion& occlusion) {
  const Eigen::Vector3d& n = point.normal;
  const double facing = std::clamp(n.dot(point.to_camera), 0.0, 1.0);
  const Eigen::Vector3d mirror = (2.0 * n.dot(point.to_camera) * n - point.to_camera).normalized();

  double floor_open = 1.0;  // the floor near the body is dark, and so is its reflection
  if (mirror.z() < -1e-3) {
    const double distance =
        std::max(0.0, (point.position.z() - occlusion.ground_height()) / -mirror.z());
    floor_open = floor_light(occlusion.ground(point.position.x() + distance * mirror.x(),
                                              point.position.y() + distance * mirror.y()));
  }
  const double hemisphere = 0.30 + 0.70 * smooth_step(-0.9, 1.0, n.z());
  const double camera_fill = 0.20 * facing;
  const float diffuse = static_cast<float>(point.open * (hemisphere + camera_fill));
  const float sheen = static_cast<float>((0.35 + 0.65 * point.open) * (0.4 + 0.6 * floor_open));
  const double fresnel = 0.07 + 0.80 * std::pow(1.0 - facing, 4.0);
  const float coat = static_cast<float>(fresnel * (0.25 + 0.75 * point.open) * floor_open);
  const Color light = base * (0.50f * diffuse) +
                      base * studio_light(mirror, 0.22) * (0.85f * sheen) +
                      studio_light(mirror, 0.02) * coat;
  return tone_mapped(light);
}

float form_light(const ShadedPoint& point) {
  const double facing = std::clamp(point.normal.dot(point.to_camera), 0.0, 1.0);
  const double above = 0.5 + 0.5 * point.normal.z();
  return static_cast<float>((0.70 + 0.16 * facing + 0.14 * above) * (0.7 + 0.3 * point.open));
}

Color inside_color(const ShadedPoint& point) {
  const double facing = std::clamp(point.normal.dot(point.to_camera), 0.0, 1.0);
  const float light = static_cast<float>(0.020 + 0.035 * facing);
  return {light, light, 1.08f * light};
}

float floor_light(double open) {
  return static_cast<float>(0.10 + 0.90 * std::pow(std::clamp(open, 0.0, 1.0), 1.2));
}

}  // namespace bodyline::io
