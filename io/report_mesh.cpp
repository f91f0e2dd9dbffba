#include "io/report_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "io/tessellate.hpp"
#include "model/factors.hpp"

namespace bodyline::io {
namespace {

constexpr int cells_per_face = 16;
constexpr double full = 32767.0;
// Normals and curvatures are taken this far inside a face, in its parameters: corner patches have
// points where they have none.
constexpr double inset = 1e-3;

bool same_faces(const std::vector<model::Surface>& a, const std::vector<model::Surface>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.name == y.name; });
}

void append(std::vector<std::uint8_t>& bytes, double fraction) {
  const double clamped = std::isfinite(fraction) ? std::clamp(fraction, -1.0, 1.0) : 0.0;
  const auto bits =
      static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(full * clamped)));
  bytes.push_back(static_cast<std::uint8_t>(bits & 0xff));
  bytes.push_back(static_cast<std::uint8_t>(bits >> 8));
}

void append(std::vector<std::uint8_t>& bytes, const Eigen::Vector3d& fractions) {
  for (int k = 0; k < 3; ++k) append(bytes, fractions[k]);
}

struct Frame3 {
  Eigen::Vector3d centre;
  double half_size = 1.0;
};

Frame3 common_frame(const std::vector<FaceGrid>& before, const std::vector<FaceGrid>& after) {
  Eigen::AlignedBox3d box;
  for (const auto* grids : {&before, &after}) {
    for (const FaceGrid& grid : *grids) {
      for (const Eigen::Vector3d& point : grid.points) box.extend(point);
    }
  }
  Frame3 frame{box.center(), std::max(0.5 * box.diagonal().norm(), 1e-6)};
  frame.centre.y() = 0.0;  // the plane of symmetry
  return frame;
}

std::vector<std::uint8_t> vertices(const std::vector<model::Surface>& faces,
                                   const std::vector<FaceGrid>& grids, const Frame3& frame,
                                   const ReportValue& value_at) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int k = 0; k < int(grids[f].points.size()); ++k) {
      const auto parameter = [&](int index) {
        return std::clamp(double(index) / cells_per_face, inset, 1.0 - inset);
      };
      const double u = parameter(k / (cells_per_face + 1)), v = parameter(k % (cells_per_face + 1));
      const double value = value_at(faces[f], u, v);
      append(bytes, (grids[f].points[k] - frame.centre) / frame.half_size);
      append(bytes, value);
      append(bytes, model::outward_normal(faces[f], u, v));
      append(bytes, std::isnan(value) ? 0.0 : 1.0);
    }
  }
  return bytes;
}

}  // namespace

ReportValue curvature_value(double range) {
  return [range](const model::Surface& face, double u, double v) {
    const double mean = model::curvature(model::jet(face, u, v, 2), face.inward).mean;
    return std::isfinite(mean) ? model::mm_per_m * mean / range : 0.0;
  };
}

ReportValue field_value(const SurfaceField& field) {
  return [&field](const model::Surface& face, double u, double v) {
    const FaceField* const values = field.face(face.name);
    return values != nullptr ? values->sample(u, v) / field.range : std::nan("");
  };
}

ReportMesh report_mesh(const std::vector<model::Surface>& before,
                       const std::vector<model::Surface>& after, const ReportValue& value) {
  ReportMesh mesh;
  if (!same_faces(before, after)) return mesh;
  const std::vector<FaceGrid> grids_before = tessellate(before, cells_per_face);
  const std::vector<FaceGrid> grids_after = tessellate(after, cells_per_face);
  const Frame3 frame = common_frame(grids_before, grids_after);
  mesh.cells = cells_per_face;
  for (const model::Surface& face : before) mesh.mirrored.push_back(!face.central);
  mesh.before = vertices(before, grids_before, frame, value);
  mesh.after = vertices(after, grids_after, frame, value);
  return mesh;
}

}  // namespace bodyline::io
