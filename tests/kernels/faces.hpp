#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "model/face_rule.hpp"
#include "tests/kernels/reference.hpp"

/// Faces for the tests of the kernels.
namespace bodyline::test {

/// A wavy, twisted patch of about 1 x 0.7 without symmetry, the same for the same seed. Where
/// `fold` is 1 it is twisted so far that its normals turn over.
Face wavy_face(const model::FaceTables& tables, unsigned seed, double fold = 0.0);

/// The polynomial that interpolates `point(u, v)` at evenly spaced parameters.
template <class PointAt>
Face interpolated_face(const model::FaceTables& tables, PointAt point);

/// Control points of the interpolant of the values at i / degree_u, j / degree_v; both laid out
/// like a net.
std::vector<double> interpolated_net(int degree_u, int degree_v, const std::vector<double>& values);

template <class PointAt>
Face interpolated_face(const model::FaceTables& tables, PointAt point) {
  const int degree_u = tables.rule().degree_u, degree_v = tables.rule().degree_v;
  std::vector<double> values;
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j) {
      const Eigen::Vector3d p = point(double(i) / degree_u, double(j) / degree_v);
      values.insert(values.end(), p.data(), p.data() + 3);
    }
  }
  return {&tables, interpolated_net(degree_u, degree_v, values), {}};
}

/// The same face with each point of its net (not the blend) mapped.
template <class Map>
Face mapped_face(Face face, Map map) {
  for (std::size_t k = 0; k < face.net.size(); k += 3) {
    const Eigen::Vector3d p = map(Eigen::Vector3d(face.net[k], face.net[k + 1], face.net[k + 2]));
    face.net[k] = p.x(), face.net[k + 1] = p.y(), face.net[k + 2] = p.z();
  }
  return face;
}

std::vector<model::Isa> available_sets();
std::string isa_text(model::Isa isa);

double energy_value(const model::Kernels& kernels, const Face& face, Energy energy);

/// Value and gradient (net, then blend where the face has one) from a pullback kernel.
std::pair<double, std::vector<double>> energy_pullback(const model::Kernels& kernels,
                                                       const Face& face, Energy energy,
                                                       double seed = 1.0);

/// Degrees (u, v) of the faces of a body, of later surface families, and the extremes.
const std::vector<std::pair<int, int>>& tested_degrees();

}  // namespace bodyline::test
