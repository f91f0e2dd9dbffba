#include "export_house.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <random>

#include "model/bernstein.hpp"
#include "model/face_rule.hpp"

namespace bodyline::test {
namespace {

using model::Surface;
using Points = std::vector<Eigen::Vector3d>;

constexpr int curve_degree = 3, high_degree = 6;
constexpr int apex = 8;

/// Vertices 0 to 3 around the floor, 4 to 7 above them, 8 the apex, and the cubic curves between
/// them.
class Frame {
 public:
  explicit Frame(unsigned seed) : random_(seed) {
    for (double z : {0.0, 800.0})
      for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 900.0}, {0.0, 900.0}})
        vertices_.emplace_back(x, y, z);
    vertices_.emplace_back(520.0, 430.0, 1300.0);
  }

  Eigen::Vector3d jitter(double size) {
    std::uniform_real_distribution<double> range(-size, size);
    const double x = range(random_), y = range(random_), z = range(random_);
    return {x, y, z};
  }

  /// The curve from one vertex to another; the same one, reversed, the other way.
  Points curve(int from, int to) {
    if (from == to) return Points(curve_degree + 1, vertices_[from]);
    const auto key = std::minmax(from, to);
    auto [at, is_new] = curves_.try_emplace(key);
    if (is_new)
      for (int k = 0; k <= curve_degree; ++k) {
        const double t = static_cast<double>(k) / curve_degree;
        const Eigen::Vector3d bulge =
            k == 0 || k == curve_degree ? Eigen::Vector3d(0, 0, 0) : jitter(60.0);
        at->second.push_back((1.0 - t) * vertices_[key.first] + t * vertices_[key.second] + bulge);
      }
    Points points = at->second;
    if (from > to) std::reverse(points.begin(), points.end());
    return points;
  }

 private:
  std::mt19937 random_;
  Points vertices_;
  std::map<std::pair<int, int>, Points> curves_;
};

/// The face over the vertices a (0,0), b (1,0), c (1,1), d (0,1): a Coons net with a shaken inside.
Surface make_face(Frame& frame, const std::string& name, int a, int b, int c, int d) {
  const Points v0 = frame.curve(a, b), v1 = frame.curve(d, c), u0 = frame.curve(a, d),
               u1 = frame.curve(b, c);
  Surface face;
  face.name = name;
  face.degree_u = face.degree_v = curve_degree;
  for (int i = 0; i <= curve_degree; ++i) {
    for (int j = 0; j <= curve_degree; ++j) {
      const double u = static_cast<double>(i) / curve_degree,
                   v = static_cast<double>(j) / curve_degree;
      Eigen::Vector3d p =
          (1 - v) * v0[i] + v * v1[i] + (1 - u) * u0[j] + u * u1[j] -
          ((1 - u) * ((1 - v) * v0[0] + v * v1[0]) + u * ((1 - v) * v0[3] + v * v1[3]));
      const bool inside = i > 0 && i < curve_degree && j > 0 && j < curve_degree;
      face.net.push_back(inside ? Eigen::Vector3d(p + frame.jitter(60.0)) : p);
    }
  }
  // Shared curves bit for bit, whatever rounding the sums above made.
  for (int k = 0; k <= curve_degree; ++k) {
    face.point(k, 0) = v0[k];
    face.point(k, curve_degree) = v1[k];
    face.point(0, k) = u0[k];
    face.point(curve_degree, k) = u1[k];
  }
  return face;
}

/// The same face with its parameters exchanged.
Surface transposed(const Surface& face) {
  Surface result = face;
  std::swap(result.degree_u, result.degree_v);
  for (int i = 0; i <= result.degree_u; ++i)
    for (int j = 0; j <= result.degree_v; ++j) result.point(i, j) = face.point(j, i);
  return result;
}

Surface reversed_u(const Surface& face) {
  Surface result = face;
  for (int i = 0; i <= result.degree_u; ++i)
    for (int j = 0; j <= result.degree_v; ++j)
      result.point(i, j) = face.point(face.degree_u - i, j);
  return result;
}

Surface elevated_u(const Surface& face, int degree) {
  const int m = face.degree_u;
  Surface result = face;
  result.degree_u = degree;
  result.net.assign((degree + 1) * (face.degree_v + 1), Eigen::Vector3d::Zero());
  for (int k = 0; k <= degree; ++k)
    for (int i = 0; i <= m; ++i) {
      const double c =
          model::binomial(m, i) * model::binomial(degree - m, k - i) / model::binomial(degree, k);
      for (int j = 0; j <= face.degree_v; ++j) result.point(k, j) += c * face.point(i, j);
    }
  return result;
}

Surface elevated(const Surface& face, int degree) {
  return transposed(elevated_u(transposed(elevated_u(face, degree)), degree));
}

void set_inward(Surface& face) {
  const Eigen::Vector3d centre(500.0, 450.0, 500.0);
  const auto d = model::jet(face, 0.5, 0.5, 1).d;
  face.inward = d[1].cross(d[2]).dot(d[0] - centre) < 0.0;
}

}  // namespace

std::vector<Surface> make_house(unsigned seed) {
  Frame frame(seed);
  std::vector<Surface> house;
  house.push_back(elevated(make_face(frame, "front", 0, 1, 5, 4), high_degree));
  house.back().blend = Eigen::Vector3d(4.0, -18.0, 7.0);
  house.push_back(transposed(make_face(frame, "side", 1, 2, 6, 5)));
  house.push_back(make_face(frame, "back", 2, 3, 7, 6));
  house.push_back(transposed(reversed_u(make_face(frame, "side.right", 3, 0, 4, 7))));
  house.push_back(elevated(make_face(frame, "roof_front", 4, 5, apex, apex), high_degree));
  house.push_back(reversed_u(
      transposed(elevated(make_face(frame, "roof_side", 5, 6, apex, apex), high_degree))));
  house.push_back(
      reversed_u(elevated(make_face(frame, "roof_back", 6, 7, apex, apex), high_degree)));
  house.push_back(transposed(reversed_u(make_face(frame, "roof_side.right", 7, 4, apex, apex))));
  house.push_back(make_face(frame, "floor", 0, 3, 2, 1));
  for (Surface& face : house) set_inward(face);
  return house;
}

std::vector<Surface> make_open_house(unsigned seed) {
  auto house = make_house(seed);
  house.pop_back();
  return house;
}

double enclosed_volume(const std::vector<Surface>& surfaces) {
  constexpr int nodes = 24;  // exact for the polynomial faces up to degree 6
  const model::GaussRule rule = model::gauss_rule(nodes, 0.0, 1.0);
  double volume = 0.0;
  for (const Surface& face : surfaces)
    for (int i = 0; i < nodes; ++i)
      for (int j = 0; j < nodes; ++j) {
        const auto d = model::jet(face, rule.nodes[i], rule.nodes[j], 1).d;
        const double flux = d[0].dot(d[1].cross(d[2])) / 3.0;
        volume += rule.weights[i] * rule.weights[j] * (face.inward ? -flux : flux);
      }
  return volume;
}

}  // namespace bodyline::test
