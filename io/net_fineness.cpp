#include "io/net_fineness.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bodyline::io {
namespace {

using Eigen::Vector3d;
using model::FacePieces;

constexpr int most_cells = 1024;  // of a piece, per direction

double across(const Vector3d& vector, const Vector3d& tangent) {
  const double length = tangent.norm();
  return length > 0.0 ? vector.cross(tangent).norm() / length : vector.norm();
}

int chords(double sag_at_one, double turn_at_one, const MeshOptions& options) {
  const double most_turn = options.max_turn_degrees * std::numbers::pi / 180.0;
  const double count = std::max(
      {1.0, std::sqrt(sag_at_one / options.tolerance_mm), std::min(64.0, turn_at_one / most_turn)});
  return std::isfinite(count) ? std::min(most_cells, static_cast<int>(std::ceil(count)))
                              : most_cells;
}

// From the second differences of the points of each piece: what bends it, and how far it turns.
std::vector<int> edge_chords(const model::SplineCurve& curve, const MeshOptions& options) {
  std::vector<int> counts;
  for (int k = 0; k < curve.pieces(); ++k) {
    const Vector3d* p = curve.piece(k);
    const int n = curve.degree;
    const double length = (p[n] - p[0]).norm();
    double bend = 0.0;
    for (int i = 0; i + 2 <= n; ++i)
      bend = std::max(bend, n * (n - 1) * across(p[i] - 2.0 * p[i + 1] + p[i + 2], p[n] - p[0]));
    counts.push_back(chords(bend / 8.0, length > 0.0 ? bend / length : 0.0, options));
  }
  return counts;
}

// Cells of a piece of a face, from its second derivatives along its normal at a few places.
std::array<int, 2> piece_cells(const model::Surface& piece, const MeshOptions& options) {
  double uu = 0.0, vv = 0.0, turn_u = 0.0, turn_v = 0.0;
  for (const double u : {0.1, 0.5, 0.9}) {
    for (const double v : {0.1, 0.5, 0.9}) {
      const auto d = model::jet(piece, u, v, 2).d;
      const Vector3d normal = model::outward_normal(piece, u, v);
      uu = std::max(uu, std::abs(normal.dot(d[3])));
      vv = std::max(vv, std::abs(normal.dot(d[5])));
      if (d[1].norm() > 0.0) turn_u = std::max(turn_u, std::abs(normal.dot(d[3])) / d[1].norm());
      if (d[2].norm() > 0.0) turn_v = std::max(turn_v, std::abs(normal.dot(d[5])) / d[2].norm());
    }
  }
  return {chords(2.0 * uu / 8.0, turn_u, options), chords(2.0 * vv / 8.0, turn_v, options)};
}

void refine(std::vector<int>& counts, double factor) {
  for (int& count : counts)
    count = std::min(most_cells, static_cast<int>(std::ceil(count * factor)));
}

}  // namespace

Fineness first_fineness(const model::FaceNet& net, const std::vector<FacePieces>& pieces,
                        const MeshOptions& options) {
  Fineness fineness;
  for (const model::NetEdge& edge : net.edges)
    fineness.edge.push_back(edge_chords(edge.curve, options));
  for (const FacePieces& face : pieces) {
    std::vector<int> in_u(face.pieces_u(), 1), in_v(face.pieces_v(), 1);
    for (int i = 0; i < face.pieces_u(); ++i) {
      for (int j = 0; j < face.pieces_v(); ++j) {
        const auto cells = piece_cells(face.piece(i, j), options);
        in_u[i] = std::max(in_u[i], cells[0]);
        in_v[j] = std::max(in_v[j], cells[1]);
      }
    }
    if (in_u.size() == 1) in_u[0] = std::max(in_u[0], 2);  // a line inside is needed
    if (in_v.size() == 1) in_v[0] = std::max(in_v[0], 2);
    fineness.face_u.push_back(std::move(in_u));
    fineness.face_v.push_back(std::move(in_v));
  }
  return fineness;
}

// Chords deviate by the square of their length; a little more spares a further round.
void refine(const model::FaceNet& net, const std::vector<double>& deviations, double tolerance,
            Fineness& fineness) {
  std::vector<double> edge_factor(net.edges.size(), 1.0);
  for (std::size_t f = 0; f < net.faces.size(); ++f) {
    if (deviations[f] <= tolerance) continue;
    const double factor = 1.05 * std::min(2.0, std::sqrt(deviations[f] / tolerance));
    refine(fineness.face_u[f], factor);
    refine(fineness.face_v[f], factor);
    for (const auto& side : net.faces[f].sides)
      for (const model::NetSidePart& part : side)
        edge_factor[part.edge] = std::max(edge_factor[part.edge], factor);
  }
  for (std::size_t e = 0; e < net.edges.size(); ++e)
    if (edge_factor[e] > 1.0) refine(fineness.edge[e], edge_factor[e]);
}

long triangle_count(const Fineness& fineness) {
  long sum = 0;
  for (std::size_t f = 0; f < fineness.face_u.size(); ++f) {
    long u = 0, v = 0;
    for (const int count : fineness.face_u[f]) u += count;
    for (const int count : fineness.face_v[f]) v += count;
    sum += 2 * u * v;
  }
  return sum;
}

std::vector<double> cut_lines(const std::vector<double>& breaks, const std::vector<int>& counts) {
  std::vector<double> result{0.0};
  for (std::size_t k = 0; k < counts.size(); ++k)
    for (int i = 1; i <= counts[k]; ++i)
      result.push_back(i == counts[k] ? breaks[k + 1]
                                      : breaks[k] + (breaks[k + 1] - breaks[k]) * i / counts[k]);
  return result;
}

}  // namespace bodyline::io
