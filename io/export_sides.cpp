#include "io/export_sides.hpp"

#include <algorithm>
#include <numeric>

#include "model/bernstein.hpp"
#include "model/face_net.hpp"

namespace bodyline::io {
namespace {

using model::Side;

constexpr int samples_per_side = 9;
using Samples = std::array<Eigen::Vector3d, samples_per_side>;

Eigen::Vector3d bezier_point(const std::vector<Eigen::Vector3d>& points, double t) {
  const auto basis = model::bernstein(static_cast<int>(points.size()) - 1, t);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += basis.d[0][i] * points[i];
  return sum;
}

Samples sample(const std::vector<Eigen::Vector3d>& points) {
  Samples samples;
  for (int k = 0; k < samples_per_side; ++k)
    samples[k] = bezier_point(points, static_cast<double>(k) / (samples_per_side - 1));
  return samples;
}

double distance(const Samples& a, const Samples& b, bool reversed) {
  double largest = 0.0;
  for (int k = 0; k < samples_per_side; ++k) {
    const int l = reversed ? samples_per_side - 1 - k : k;
    largest = std::max(largest, (a[k] - b[l]).norm());
  }
  return largest;
}

bool shrunk_to_point(const std::vector<Eigen::Vector3d>& points, double tolerance) {
  return std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return (p - points.front()).norm() <= tolerance; });
}

/// Groups that only ever merge.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void merge(int i, int j) {
    const int a = find(i), b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

/// The curve among those with one use that runs like `samples`, or -1; sets `reversed` and `gap`.
int find_partner(const SideGraph& graph, const std::vector<Samples>& of_curve,
                 const Samples& samples, int face, double tolerance, bool& reversed, double& gap) {
  for (int c = 0; c < static_cast<int>(graph.curves.size()); ++c) {
    const SharedCurve& curve = graph.curves[c];
    if (curve.degenerate || curve.uses.size() != 1 || curve.uses[0].face == face) continue;
    for (bool against : {false, true}) {
      gap = distance(of_curve[c], samples, against);
      reversed = against;
      if (gap <= tolerance) return c;
    }
  }
  return -1;
}

void match_curves(SideGraph& graph, const std::vector<model::Surface>& surfaces, double tolerance) {
  std::vector<Samples> of_curve;
  for (int f = 0; f < static_cast<int>(surfaces.size()); ++f) {
    for (Side side : model::all_sides) {
      const int s = static_cast<int>(side);
      const auto points = side_points(surfaces[f], side);
      const Samples samples = sample(points);
      const bool degenerate = shrunk_to_point(points, tolerance);
      bool reversed = false;
      double gap = 0.0;
      int partner =
          degenerate ? -1 : find_partner(graph, of_curve, samples, f, tolerance, reversed, gap);
      if (partner < 0) {
        partner = static_cast<int>(graph.curves.size());
        graph.curves.push_back(
            {.uses = {}, .start = -1, .end = -1, .degenerate = degenerate, .gap_mm = 0.0});
        of_curve.push_back(samples);
        reversed = false;
      } else {
        graph.curves[partner].gap_mm = gap;
      }
      graph.curves[partner].uses.push_back({f, side, reversed});
      graph.side_curve[f][s] = partner;
      graph.side_against[f][s] = reversed;
    }
  }
}

/// Numbers the vertices: corners of faces that share a curve, or the ends of a degenerate side, are
/// one.
void match_vertices(SideGraph& graph, const std::vector<model::Surface>& surfaces) {
  Groups groups(4 * surfaces.size());
  for (const SharedCurve& curve : graph.curves) {
    const auto first = side_corners(curve.uses[0].side);
    if (curve.degenerate)
      groups.merge(4 * curve.uses[0].face + first[0], 4 * curve.uses[0].face + first[1]);
    if (curve.uses.size() < 2) continue;
    const SideUse& other = curve.uses[1];
    auto second = side_corners(other.side);
    if (other.reversed) std::swap(second[0], second[1]);
    for (int end : {0, 1})
      groups.merge(4 * curve.uses[0].face + first[end], 4 * other.face + second[end]);
  }
  std::vector<int> number(4 * surfaces.size(), -1);
  for (int f = 0; f < static_cast<int>(surfaces.size()); ++f) {
    const model::Surface& s = surfaces[f];
    const std::array<Eigen::Vector3d, 4> corner{s.point(0, 0), s.point(s.degree_u, 0),
                                                s.point(s.degree_u, s.degree_v),
                                                s.point(0, s.degree_v)};
    for (int k = 0; k < 4; ++k) {
      int& vertex = number[groups.find(4 * f + k)];
      if (vertex < 0) {
        vertex = static_cast<int>(graph.vertices.size());
        graph.vertices.push_back(corner[k]);
      }
      graph.face_vertex[f][k] = vertex;
    }
  }
  for (SharedCurve& curve : graph.curves) {
    const auto corners = side_corners(curve.uses[0].side);
    curve.start = graph.face_vertex[curve.uses[0].face][corners[0]];
    curve.end = graph.face_vertex[curve.uses[0].face][corners[1]];
  }
}

}  // namespace

std::vector<Eigen::Vector3d> side_points(const model::Surface& surface, Side side) {
  const bool along_v = side == Side::u0 || side == Side::u1;
  const int count = (along_v ? surface.degree_v : surface.degree_u) + 1;
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    if (along_v)
      points.push_back(surface.point(side == Side::u0 ? 0 : surface.degree_u, k));
    else
      points.push_back(surface.point(k, side == Side::v0 ? 0 : surface.degree_v));
  }
  return points;
}

Eigen::Vector2d side_parameters(Side side, double fraction) {
  switch (side) {
    case Side::u0:
      return {0.0, fraction};
    case Side::u1:
      return {1.0, fraction};
    case Side::v0:
      return {fraction, 0.0};
    default:
      return {fraction, 1.0};
  }
}

SideGraph match_sides(const std::vector<model::Surface>& surfaces, double tolerance_mm) {
  SideGraph graph;
  graph.side_curve.resize(surfaces.size());
  graph.side_against.resize(surfaces.size());
  graph.face_vertex.resize(surfaces.size());
  match_curves(graph, surfaces, tolerance_mm);
  match_vertices(graph, surfaces);
  return graph;
}

}  // namespace bodyline::io
