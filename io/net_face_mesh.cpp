#include "io/net_face_mesh.hpp"

#include <algorithm>

#include "io/export_sides.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::FacePieces;
using model::NetFace;
using model::Side;

/// A row of vertices of a face and where along it they are.
struct Row {
  std::vector<double> at;
  std::vector<int> vertex;
};

class FaceMesher {
 public:
  FaceMesher(const NetFace& face, const FacePieces& pieces, MeshVertices& vertices)
      : face_(face), pieces_(pieces), vertices_(vertices) {}

  FaceMesh run(const std::vector<double>& u, const std::vector<double>& v,
               const std::vector<EdgePoints>& edges, const std::vector<int>& corner_points) {
    for (int k = 0; k < 4; ++k) {
      const Vector2d uv(k == 1 || k == 2 ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0);
      corners_[k] = add(corner_points[face_.corners[k]], uv);
    }
    const int rows = static_cast<int>(u.size()) - 2, columns = static_cast<int>(v.size()) - 2;
    std::vector<int> inside;
    for (int i = 1; i <= rows; ++i)
      for (int j = 1; j <= columns; ++j)
        inside.push_back(add(vertices_.add_point(pieces_.jet(u[i], v[j], 0).d[0]), {u[i], v[j]}));
    const auto at = [&](int i, int j) { return inside[(i - 1) * columns + j - 1]; };
    for (int i = 1; i < rows; ++i)
      for (int j = 1; j < columns; ++j)
        add_cell(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    Row low, high, left, right;
    for (int i = 1; i <= rows; ++i) {
      low.at.push_back(u[i]), low.vertex.push_back(at(i, 1));
      high.at.push_back(u[i]), high.vertex.push_back(at(i, columns));
    }
    for (int j = 1; j <= columns; ++j) {
      left.at.push_back(v[j]), left.vertex.push_back(at(1, j));
      right.at.push_back(v[j]), right.vertex.push_back(at(rows, j));
    }
    add_strip(side_row(Side::v0, edges), low, false);
    add_strip(side_row(Side::u1, edges), right, false);
    add_strip(side_row(Side::v1, edges), high, true);
    add_strip(side_row(Side::u0, edges), left, true);
    return std::move(mesh_);
  }

 private:
  int add(int point, const Vector2d& uv) {
    const Vector3d normal = pieces_.outward_normal(uv.x(), uv.y());
    mesh_.vertices.push_back({point, vertices_.add_normal(point, normal), uv});
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }
  const Eigen::Vector3f& place(int vertex) const {
    return vertices_.point(mesh_.vertices[vertex].point);
  }
  void add_cell(int a, int b, int c, int d) {
    const auto worst = [this](int p, int q, int r, int s) {
      return std::min(triangle_quality(place(p), place(q), place(r)),
                      triangle_quality(place(p), place(r), place(s)));
    };
    const bool first = worst(a, b, c, d) >= worst(b, c, d, a);
    if (first) {
      mesh_.triangles.insert(mesh_.triangles.end(), {{a, b, c}, {a, c, d}});
    } else {
      mesh_.triangles.insert(mesh_.triangles.end(), {{b, c, d}, {b, d, a}});
    }
  }
  // The vertices of a side, along its running parameter, corners included; of a point, its corner.
  Row side_row(Side side, const std::vector<EdgePoints>& edges) {
    const auto ends = side_corners(side);
    Row row{{0.0}, {corners_[ends[0]]}};
    const auto& parts = face_.sides[static_cast<int>(side)];
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const EdgePoints& points = edges[parts[k].edge];
      const std::size_t count = points.t.size();
      for (std::size_t i = 1; i < count; ++i) {
        if (i + 1 == count && k + 1 == parts.size()) break;
        const std::size_t from = parts[k].reversed ? count - 1 - i : i;
        const double t = parts[k].reversed ? 1.0 - points.t[from] : points.t[from];
        const double along = parts[k].from + t * (parts[k].to - parts[k].from);
        row.at.push_back(along);
        row.vertex.push_back(add(points.point[from], side_parameters(side, along)));
      }
    }
    if (parts.empty()) return row;
    row.at.push_back(1.0);
    row.vertex.push_back(corners_[ends[1]]);
    return row;
  }
  // Triangles between a side and the row next to it; `turned` where the row lies to the right of
  // it.
  void add_strip(const Row& side, const Row& row, bool turned) {
    std::size_t a = 0, b = 0;
    while (a + 1 < side.at.size() || b + 1 < row.at.size()) {
      const bool along_side =
          b + 1 == row.at.size() || (a + 1 < side.at.size() && side.at[a + 1] <= row.at[b + 1]);
      const int third = along_side ? side.vertex[a + 1] : row.vertex[b + 1];
      std::array<int, 3> triangle{side.vertex[a], third, row.vertex[b]};
      if (turned) std::swap(triangle[1], triangle[2]);
      mesh_.triangles.push_back(triangle);
      ++(along_side ? a : b);
    }
  }

  const NetFace& face_;
  const FacePieces& pieces_;
  MeshVertices& vertices_;
  FaceMesh mesh_;
  std::array<int, 4> corners_{};
};

}  // namespace

FaceMesh make_face_mesh(const NetFace& face, const FacePieces& pieces, const std::vector<double>& u,
                        const std::vector<double>& v, const std::vector<EdgePoints>& edges,
                        const std::vector<int>& corner_points, MeshVertices& vertices) {
  return FaceMesher(face, pieces, vertices).run(u, v, edges, corner_points);
}

}  // namespace bodyline::io
