#include "model/contour.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace bodyline::model {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double edge_on = 1e-9;  // cosines below this are rounding
constexpr double exact = 1e-10;
constexpr int newton_steps = 30, root_steps = 80;

// f = (Su x Sv) . toward, which is zero along contours, with its derivatives, and |Su x Sv|.
struct Facing {
  double value = 0.0, length = 0.0;
  Vector2d slope;
  bool grazes() const { return std::abs(value) <= exact * length; }
};

Facing facing_at(const Surface& face, const Vector3d& toward, const Vector2d& at) {
  const SurfaceJet j = jet(face, at.x(), at.y(), 2);
  const Vector3d normal = j.d[1].cross(j.d[2]);
  Facing facing;
  facing.value = normal.dot(toward);
  facing.length = normal.norm();
  facing.slope = {(j.d[3].cross(j.d[2]) + j.d[1].cross(j.d[4])).dot(toward),
                  (j.d[4].cross(j.d[2]) + j.d[1].cross(j.d[5])).dot(toward)};
  return facing;
}

// The zero of f between two points of different sign: Newton's method within a shrinking bracket.
Vector2d root_between(const Surface& face, const Vector3d& toward, const Vector2d& from,
                      const Vector2d& to, double value_from, double value_to) {
  const Vector2d along = to - from;
  const bool rising = value_to > value_from;
  double low = 0.0, high = 1.0, t = value_from / (value_from - value_to);
  for (int step = 0; step < root_steps && high > low; ++step) {
    const Facing facing = facing_at(face, toward, from + t * along);
    if (facing.grazes()) break;
    // The values are of outward normals; f turns with the parameters.
    const double value = face.inward ? -facing.value : facing.value;
    ((value > 0.0) == rising ? high : low) = t;
    const double slope = facing.slope.dot(along);
    const double next = t - facing.value / slope;
    t = next > low && next < high ? next : 0.5 * (low + high);
  }
  return from + t * along;
}

// Marching squares. Edges of the grid are numbered: first those along v, then those along u.
class Marcher {
 public:
  Marcher(const Surface& face, const Vector3d& toward, const FacingGrid& grid)
      : face_(face), toward_(toward), values_(grid.facing), m_(grid.cells_u), n_(grid.cells_v) {}

  std::vector<Contour> contours();

 private:
  int edge_v(int i, int j) const { return i * n_ + j; }
  int edge_u(int i, int j) const { return (m_ + 1) * n_ + i * (n_ + 1) + j; }
  double value(int i, int j) const { return values_[i * (n_ + 1) + j]; }
  bool crossed(int i, int j, int k, int l) const;
  void link_cell(int i, int j);
  void link(int a, int b);
  Contour walk(int start);
  Vector2d point(int edge) const;

  const Surface& face_;
  const Vector3d& toward_;
  const std::vector<double>& values_;
  int m_, n_;
  std::vector<std::array<int, 2>> next_;  // by edge: the edges that the contour goes to
};

bool Marcher::crossed(int i, int j, int k, int l) const {
  const double a = value(i, j), b = value(k, l);
  if (std::isnan(a) || std::isnan(b) || std::max(std::abs(a), std::abs(b)) <= edge_on) return false;
  return (a > 0.0) != (b > 0.0);
}

void Marcher::link(int a, int b) {
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
    std::array<int, 2>& links = next_[from];
    links[links[0] < 0 ? 0 : 1] = to;
  }
}

void Marcher::link_cell(int i, int j) {
  // Edges in the order around the cell, beginning at its corner (i, j).
  const std::array<int, 4> edges{edge_v(i, j), edge_u(i, j + 1), edge_v(i + 1, j), edge_u(i, j)};
  const std::array<bool, 4> cut{crossed(i, j, i, j + 1), crossed(i, j + 1, i + 1, j + 1),
                                crossed(i + 1, j + 1, i + 1, j), crossed(i + 1, j, i, j)};
  std::array<int, 4> found{};
  int count = 0;
  for (int k = 0; k < 4; ++k) {
    if (cut[k]) found[count++] = edges[k];
  }
  if (count == 2) link(found[0], found[1]);
  if (count < 4) return;
  // A saddle: the sign in the middle tells which corners are joined.
  const Facing middle = facing_at(face_, toward_, {(i + 0.5) / m_, (j + 0.5) / n_});
  const bool middle_faces = (face_.inward ? -middle.value : middle.value) > 0.0;
  const int turn = middle_faces == (value(i, j) > 0.0) ? 0 : 3;
  link(found[turn], found[(turn + 1) % 4]);
  link(found[(turn + 2) % 4], found[(turn + 3) % 4]);
}

Vector2d Marcher::point(int edge) const {
  const bool along_v = edge < (m_ + 1) * n_;
  const int k = along_v ? edge : edge - (m_ + 1) * n_;
  const int i = along_v ? k / n_ : k / (n_ + 1), j = along_v ? k % n_ : k % (n_ + 1);
  const int i2 = along_v ? i : i + 1, j2 = along_v ? j + 1 : j;
  return root_between(face_, toward_, {double(i) / m_, double(j) / n_},
                      {double(i2) / m_, double(j2) / n_}, value(i, j), value(i2, j2));
}

// Follows the links from an edge and takes them out.
Contour Marcher::walk(int start) {
  Contour contour;
  int at = start;
  while (at >= 0) {
    contour.points.push_back(point(at));
    const int to = next_[at][0] >= 0 ? next_[at][0] : next_[at][1];
    if (to < 0) break;
    for (const auto& [from, gone] : {std::pair{at, to}, std::pair{to, at}}) {
      std::array<int, 2>& links = next_[from];
      links[links[0] == gone ? 0 : 1] = -1;
    }
    at = to;
    if (at == start) {
      contour.closed = true;
      break;
    }
  }
  return contour;
}

std::vector<Contour> Marcher::contours() {
  next_.assign((m_ + 1) * n_ + m_ * (n_ + 1), {-1, -1});
  for (int i = 0; i < m_; ++i) {
    for (int j = 0; j < n_; ++j) link_cell(i, j);
  }
  std::vector<Contour> found;
  const auto links = [&](int edge) { return (next_[edge][0] >= 0) + (next_[edge][1] >= 0); };
  for (const int wanted : {1, 2}) {  // those with ends first
    for (int edge = 0; edge < int(next_.size()); ++edge) {
      if (links(edge) == wanted) found.push_back(walk(edge));
    }
  }
  return found;
}

}  // namespace

FacingGrid facing_grid(const Surface& face, const Vector3d& toward, int cells_u, int cells_v) {
  // A sine below this may be that of a degenerate corner, where only the limit counts.
  constexpr double degenerate_sine = 1e-6;
  FacingGrid grid{cells_u, cells_v, {}, {}};
  for (int i = 0; i <= cells_u; ++i) {
    for (int j = 0; j <= cells_v; ++j) {
      const double u = double(i) / cells_u, v = double(j) / cells_v;
      const SurfaceJet at = jet(face, u, v, 1);
      const Vector3d normal = at.d[1].cross(at.d[2]);
      const double scale = std::max(at.d[1].squaredNorm(), at.d[2].squaredNorm());
      const bool regular = normal.norm() > degenerate_sine * scale;
      const double facing = (regular ? normal.normalized().dot(toward) * (face.inward ? -1.0 : 1.0)
                                     : outward_normal(face, u, v).dot(toward));
      grid.positions.push_back(at.d[0]);
      grid.facing.push_back(facing);
    }
  }
  return grid;
}

std::vector<Contour> trace_contours(const Surface& face, const Vector3d& toward,
                                    const FacingGrid& grid) {
  return Marcher(face, toward, grid).contours();
}

bool refine_contour(const Surface& face, const Vector3d& toward, Vector2d& at) {
  for (int step = 0; step < newton_steps; ++step) {
    const Facing facing = facing_at(face, toward, at);
    if (facing.length > 0.0 && facing.grazes()) return true;
    // At the border of the face the move is along it.
    Vector2d slope = facing.slope;
    for (int c = 0; c < 2; ++c) {
      const double move = -facing.value * slope[c];
      if ((at[c] <= 0.0 && move < 0.0) || (at[c] >= 1.0 && move > 0.0)) slope[c] = 0.0;
    }
    const double squared = slope.squaredNorm();
    if (!(squared > 0.0)) return false;
    at -= facing.value / squared * slope;
    at = at.cwiseMax(0.0).cwiseMin(1.0);
  }
  return false;
}

}  // namespace bodyline::model
