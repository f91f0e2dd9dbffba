#include "optimize/distance_row.hpp"

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"

namespace bodyline::optimize {
namespace {

// Adds -weight * normal . (the point of the nets there), and takes its value at the nets away.
void add_point(NetRow& row, int point, double weight, const Eigen::Vector3d& normal,
               const double* nets) {
  for (int axis = 0; axis < 3; ++axis) {
    const int number = 3 * point + axis;
    row.slopes.push_back({number, -weight * normal[axis]});
    row.offset += weight * normal[axis] * nets[number];
  }
}

}  // namespace

NetRow distance_row(const model::Face& face, const Match& match, const Eigen::Vector3d& normal,
                    const double* nets) {
  const auto in_u = model::bernstein(face.degree_u, match.u);
  const auto in_v = model::bernstein(face.degree_v, match.v);
  NetRow row;
  row.offset = match.distance;
  for (int i = 0; i <= face.degree_u; ++i) {
    for (int j = 0; j <= face.degree_v; ++j)
      add_point(row, face.net + i * (face.degree_v + 1) + j, in_u.d[0][i] * in_v.d[0][j], normal,
                nets);
  }
  if (face.blend >= 0)
    add_point(row, face.blend, model::blend_jet(match.u, match.v)[0], normal, nets);
  return row;
}

}  // namespace bodyline::optimize
