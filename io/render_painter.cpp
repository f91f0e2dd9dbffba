#include "io/render_painter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "io/render_studio.hpp"

namespace bodyline::io {
namespace {

// A level parallel view would show the floor edge-on; it is drawn as if seen from this many degrees
// above.
constexpr double floor_tilt = 7.0;
constexpr double line_half_width = 0.55;  // pixels
constexpr float floor_mirror = 0.16f;  // how much of the body the polished floor shows at its foot

// The factor by which Su x Sv must exceed rounding before it is trusted.
constexpr double degenerate_sine = 1e-6;

// The normal of the face turned towards the viewer.
Eigen::Vector3d viewed_normal(const model::Surface& face, const model::SurfaceJet& jet,
                              const Hit& hit) {
  const Eigen::Vector3d cross = jet.d[1].cross(jet.d[2]);
  const double scale = std::max(jet.d[1].squaredNorm(), jet.d[2].squaredNorm());
  const bool regular = cross.norm() > degenerate_sine * scale;
  Eigen::Vector3d normal =
      regular ? Eigen::Vector3d(cross.normalized()) : model::outward_normal(face, hit.u, hit.v);
  if (!regular && face.inward) normal = -normal;
  if (hit.along_normal) normal = -normal;
  return normal;
}

}  // namespace

Painter::Painter(const std::vector<model::Surface>& faces, const RayScene& scene,
                 const Occlusion& occlusion, const MapColors& colors, const Camera& camera,
                 const std::vector<Eigen::Vector3d>& points, int picture_height)
    : faces_(faces),
      scene_(scene),
      occlusion_(occlusion),
      colors_(colors),
      camera_(camera),
      picture_height_(picture_height),
      from_above_(camera.towards().z() >= 0.0) {
  Eigen::AlignedBox3d box;
  nearest_ = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : points) {
    box.extend(point);
    nearest_ = std::max(nearest_, point.dot(camera.towards()));
  }
  size_ = box.diagonal().norm();
}

Seen Painter::look(double x, double y) const {
  const Ray ray = camera_.ray(x, y);
  if (const std::optional<Hit> hit = scene_.first_hit(ray))
    return {face_color(ray, *hit), hit->face};
  return {floor_color(ray, backdrop(y / picture_height_)), -1};
}

Color Painter::face_color(const Ray& ray, const Hit& hit) const {
  const model::Surface& face = faces_[hit.face];
  const model::SurfaceJet jet = model::jet(face, hit.u, hit.v, colors_.jet_order());
  ShadedPoint point;
  point.position = ray.origin + hit.distance * ray.direction;
  point.normal = viewed_normal(face, jet, hit);
  point.to_camera = -ray.direction;
  const bool outside = hit.along_normal == face.inward;
  if (!outside) return inside_color(point);
  point.open = occlusion_.face(hit.face, hit.u, hit.v);
  const Color color = colors_.map() == Map::field
                          ? colors_.field_color(hit.face, hit.u, hit.v)
                          : colors_.color(hit.face, jet, point.normal, point.to_camera);
  if (colors_.map() == Map::shade) return paint(point, color, occlusion_);
  Color lit = color * form_light(point);
  if (colors_.edge_lines()) {
    const float line = static_cast<float>(0.75 * edge_line(jet, ray, hit));
    lit = (1.0f - line) * lit + line * color_from_srgb(70, 76, 86);
  }
  return lit;
}

Color Painter::floor_color(const Ray& ray, const Color& background) const {
  if (!from_above_) return background;
  const double above = ray.origin.z() - occlusion_.ground_height();
  Eigen::Vector3d floor;
  if (camera_.towards().z() == 0.0 && !camera_.perspective()) {
    const double depth = above < 0.0 ? -above : 3.0 * above;
    const double along = nearest_ + depth / std::tan(floor_tilt * std::numbers::pi / 180.0);
    floor = ray.origin + (along - ray.origin.dot(camera_.towards())) * camera_.towards();
    return background * floor_light(occlusion_.ground(floor.x(), floor.y()));
  }
  if (ray.direction.z() >= -1e-6) return background;
  floor = ray.origin - above / ray.direction.z() * ray.direction;
  Color color = background * floor_light(occlusion_.ground(floor.x(), floor.y()));
  if (colors_.map() != Map::shade) return color;
  const Ray mirrored{floor, {ray.direction.x(), ray.direction.y(), -ray.direction.z()}};
  if (const std::optional<Hit> hit = scene_.first_hit(mirrored, 1e-4 * size_)) {
    const double height = hit->distance * mirrored.direction.z();
    const float share = floor_mirror * static_cast<float>(std::exp(-height / (0.05 * size_)));
    color = (1.0f - share) * color + share * face_color(mirrored, *hit);
  }
  return color;
}

double Painter::edge_line(const model::SurfaceJet& jet, const Ray& ray, const Hit& hit) const {
  // Distance in the picture to the nearest edge of the face, to first order.
  const double pixel = camera_.pixel_size(hit.distance);
  const Eigen::Vector3d su = jet.d[1] - jet.d[1].dot(ray.direction) * ray.direction;
  const Eigen::Vector3d sv = jet.d[2] - jet.d[2].dot(ray.direction) * ray.direction;
  const double area = su.cross(sv).norm();
  const double to_u = std::min(hit.u, 1.0 - hit.u) * area / std::max(sv.norm(), 1e-9);
  const double to_v = std::min(hit.v, 1.0 - hit.v) * area / std::max(su.norm(), 1e-9);
  const double distance = std::min(to_u, to_v) / pixel;
  return std::clamp(line_half_width + 0.5 - distance, 0.0, 1.0);
}

}  // namespace bodyline::io
