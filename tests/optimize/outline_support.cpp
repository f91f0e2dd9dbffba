#include "outline_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>

#include "io/read_model.hpp"
#include "io/trace_mask.hpp"
#include "model/silhouette.hpp"
#include "model/silhouette_outline.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;

constexpr double pixel = 2.0;  // mm
constexpr int border = 10;     // pixels

std::string mesh_path(const std::string& name) {
  return BODYLINE_SOURCE_DIR "/../shared/scans/" + name + ".ply";
}

struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

// Binary little-endian: float x y z; uchar 3, int[3].
Mesh read_mesh(const std::string& name) {
  std::ifstream file(mesh_path(name), std::ios::binary);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
  }
  Mesh mesh;
  std::array<float, 3> numbers{};
  for (std::size_t k = 0; k < vertices; ++k) {
    file.read(reinterpret_cast<char*>(numbers.data()), sizeof numbers);
    mesh.vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
  for (std::size_t k = 0; k < faces; ++k) {
    char corners = 0;
    auto& triangle = mesh.triangles.emplace_back();
    file.read(&corners, 1);
    file.read(reinterpret_cast<char*>(triangle.data()), sizeof triangle);
  }
  return mesh;
}

// Columns to the right and rows from the top; the edges of a triangle count, however thin it is.
void cover(io::Mask& mask, const std::array<Vector2d, 3>& corners) {
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).norm());
  const int steps = int(std::ceil(2.2 * longest)) + 1;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Vector2d at = corners[0] + double(i) / steps * (corners[1] - corners[0]) +
                          double(j) / steps * (corners[2] - corners[0]);
      mask.inside[std::size_t(int(at.y()) * mask.width + int(at.x()))] = 1;
    }
  }
}

}  // namespace

bool have_mesh(const std::string& name) { return std::ifstream(mesh_path(name)).good(); }

model::PlacedDrawing mask_outline(const std::string& name, model::View view) {
  const Mesh mesh = read_mesh(name);
  std::vector<Vector2d> pictures;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    pictures.push_back(model::project(view, vertex));
    box.extend(pictures.back());
  }
  io::Mask mask;
  mask.width = int(box.sizes().x() / pixel) + 2 * border;
  mask.height = int(box.sizes().y() / pixel) + 2 * border;
  mask.inside.assign(std::size_t(mask.width) * mask.height, 0);
  const auto in_pixels = [&](const Vector2d& picture) {
    return Vector2d((picture.x() - box.min().x()) / pixel + border,
                    (box.max().y() - picture.y()) / pixel + border);
  };
  for (const auto& [a, b, c] : mesh.triangles)
    cover(mask, {in_pixels(pictures[a]), in_pixels(pictures[b]), in_pixels(pictures[c])});
  model::PlacedDrawing drawing{view, io::trace_mask(mask)};
  for (model::DrawnPath& path : drawing.paths) {
    for (model::CubicSegment& segment : path.segments) {
      for (Vector2d& point : segment.points) {
        point = Vector2d(box.min().x() + pixel * (point.x() - border),
                         box.max().y() + pixel * (point.y() + border));
      }
    }
  }
  return drawing;
}

model::Model outline_test_car(const std::string& name) {
  return io::read_model(BODYLINE_SOURCE_DIR "/cars/" + name + ".toml");
}

model::DrawnPath straight_path(const std::vector<Eigen::Vector2d>& points) {
  model::DrawnPath path;
  for (std::size_t k = 1; k < points.size(); ++k)
    path.segments.push_back(model::line_segment(points[k - 1], points[k]));
  path.closed = points.size() > 3 && points.front() == points.back();
  return path;
}

std::vector<model::PlacedDrawing> traced_outlines(const model::Model& car,
                                                  const std::vector<model::View>& views,
                                                  double spacing) {
  const model::SilhouetteBody body = model::silhouette_body(car, model::Stage::body);
  model::SilhouetteOptions options;
  options.spacing = spacing;
  std::vector<model::PlacedDrawing> drawings;
  for (const model::View view : views) {
    model::PlacedDrawing& drawing = drawings.emplace_back();
    drawing.view = view;
    const auto pieces = model::silhouette(body, view, options);
    for (const auto& line : model::silhouette_outline(pieces, view))
      drawing.paths.push_back(straight_path(line));
  }
  return drawings;
}

}  // namespace bodyline::optimize
