#include "io/render_occlusion.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace bodyline::io {
namespace {

constexpr double ground_margin = 0.35;  // of the body's length, on each side

// Directions over the hemisphere around z, dense where they count most (cosine law),
// mirror-symmetric in y so that a symmetric body gets symmetric light.
std::vector<Eigen::Vector3d> hemisphere(int count) {
  constexpr double golden = 0.6180339887498949;
  std::vector<Eigen::Vector3d> directions;
  const int half = count / 2;
  for (int k = 0; k < half; ++k) {
    const double radius = std::sqrt((k + 0.5) / half);
    const double angle = std::numbers::pi * std::fmod((k + 0.5) * golden, 1.0);
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    const double z = std::sqrt(std::max(0.0, 1.0 - radius * radius));
    directions.emplace_back(x, y, z);
    directions.emplace_back(x, -y, z);
  }
  return directions;
}

// Axes around a normal; a mirrored normal gets mirrored axes.
Eigen::Matrix3d axes_around(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d start =
      std::abs(normal.x()) < 0.8 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d axes;
  axes.col(0) = (start - start.dot(normal) * normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

// One pass of the weights 1 2 1 along x and along y.
Table2 smoothed(const Table2& table) {
  Table2 result = table;
  for (int ix = 0; ix < table.nx; ++ix) {
    for (int iy = 0; iy < table.ny; ++iy) {
      float sum = 0.0f;
      for (int k = 0; k < 9; ++k) {
        const int x = std::clamp(ix + k / 3 - 1, 0, table.nx - 1);
        const int y = std::clamp(iy + k % 3 - 1, 0, table.ny - 1);
        sum += table.at(x, y) *
               static_cast<float>((2 - std::abs(k / 3 - 1)) * (2 - std::abs(k % 3 - 1)));
      }
      result.at(ix, iy) = sum / 16.0f;
    }
  }
  return result;
}

}  // namespace

double Table2::sample(double x, double y) const {
  const double px = std::clamp(x, 0.0, 1.0) * (nx - 1), py = std::clamp(y, 0.0, 1.0) * (ny - 1);
  const int ix = std::min(static_cast<int>(px), nx - 2),
            iy = std::min(static_cast<int>(py), ny - 2);
  const double fx = px - ix, fy = py - iy;
  const double low = at(ix, iy) + fy * (at(ix, iy + 1) - at(ix, iy));
  const double high = at(ix + 1, iy) + fy * (at(ix + 1, iy + 1) - at(ix + 1, iy));
  return low + fx * (high - low);
}

Occlusion::Occlusion(const RayScene& scene, const std::vector<model::Surface>& faces,
                     const std::vector<FaceGrid>& grids, const OcclusionDetail& detail)
    : detail_(detail),
      faces_(faces.size(), Table2{detail.face_cells + 1, detail.face_cells + 1, {}}),
      directions_(hemisphere(detail.face_directions)) {
  find_ground(scene, grids);
  const int face_cells = detail.face_cells;
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
    for (int i = 0; i <= face_cells; ++i) {
      for (int j = 0; j <= face_cells; ++j) {
        const double u = static_cast<double>(i) / face_cells,
                     v = static_cast<double>(j) / face_cells;
        const Eigen::Vector3d point = model::jet(faces[f], u, v, 0).d[0];
        const Eigen::Vector3d normal = model::outward_normal(faces[f], u, v);
        const double seen = normal.allFinite() ? seen_from_face(scene, point, normal) : 1.0;
        faces_[f].values.push_back(static_cast<float>(seen));
      }
    }
  });
}

void Occlusion::find_ground(const RayScene& scene, const std::vector<FaceGrid>& grids) {
  Eigen::AlignedBox3d box;
  for (const FaceGrid& grid : grids) {
    for (const Eigen::Vector3d& point : grid.points) box.extend(point);
  }
  const double length = box.diagonal().norm();
  offset_ = 4e-4 * length;
  ground_height_ = box.min().z();
  ground_low_ = (box.min().head<2>().array() - ground_margin * length).matrix();
  ground_size_ = (box.diagonal().head<2>().array() + 2.0 * ground_margin * length).matrix();
  const int ground_cells_x = detail_.ground_cells_x, ground_cells_y = detail_.ground_cells_y;
  ground_ = Table2{ground_cells_x + 1, ground_cells_y + 1, {}};
  ground_.values.resize((ground_cells_x + 1) * (ground_cells_y + 1));
  const std::vector<Eigen::Vector3d> directions = hemisphere(detail_.ground_directions);
  tbb::parallel_for(0, ground_.nx, [&](int ix) {
    for (int iy = 0; iy < ground_.ny; ++iy) {
      const double x = ground_low_.x() + ground_size_.x() * ix / ground_cells_x;
      const double y = ground_low_.y() + ground_size_.y() * iy / ground_cells_y;
      int open = 0;
      for (const Eigen::Vector3d& direction : directions) {
        open += scene.blocked({{x, y, ground_height_ - offset_}, direction}) ? 0 : 1;
      }
      ground_.at(ix, iy) = static_cast<float>(open) / static_cast<float>(directions.size());
    }
  });
  ground_ = smoothed(ground_);
}

double Occlusion::seen_from_face(const RayScene& scene, const Eigen::Vector3d& point,
                                 const Eigen::Vector3d& normal) const {
  const Eigen::Matrix3d axes = axes_around(normal);
  const Eigen::Vector3d origin = point + offset_ * normal;
  double seen = 0.0;
  for (const Eigen::Vector3d& local : directions_) {
    const Eigen::Vector3d direction = axes * local;
    if (scene.blocked({origin, direction}, offset_)) continue;
    if (direction.z() >= 0.0) {
      seen += 1.0;
    } else {
      const double distance = std::max(0.0, (origin.z() - ground_height_) / -direction.z());
      const Eigen::Vector3d floor = origin + distance * direction;
      seen += ground(floor.x(), floor.y());
    }
  }
  return seen / static_cast<double>(directions_.size());
}

double Occlusion::ground(double x, double y) const {
  return ground_.sample((x - ground_low_.x()) / ground_size_.x(),
                        (y - ground_low_.y()) / ground_size_.y());
}

}  // namespace bodyline::io
