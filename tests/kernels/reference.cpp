#include "tests/kernels/reference.hpp"

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"
#include "model/surface.hpp"
#include "tests/kernels/dual.hpp"

namespace bodyline::test {
namespace {

using Complex = std::complex<double>;
using model::jet_index;

// Small enough that its square vanishes beside any value, large enough to stay clear of underflow.
constexpr double complex_step = 1e-40;

template <class Real>
using Point = std::array<Real, 3>;
template <class Real>
using NodeJet = std::array<Point<Real>, 10>;

template <class Real>
Real dot(const Point<Real>& a, const Point<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Point<Real> cross(const Point<Real>& a, const Point<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The factor by which one coordinate of the face (of the net, or of the blend) moves jet entry (a,
/// b) at (u, v).
struct Influence {
  std::array<double, 10> factor;
  int coordinate;
};

Influence influence(const Face& face, std::size_t variable, double u, double v) {
  const model::FaceRule& rule = face.tables->rule();
  Influence result{{}, static_cast<int>(variable % 3)};
  if (variable >= face.net.size()) {
    result.factor = model::blend_jet(u, v);
    return result;
  }
  const int point = static_cast<int>(variable / 3);
  const model::BernsteinJet bu = model::bernstein(rule.degree_u, u),
                            bv = model::bernstein(rule.degree_v, v);
  for (int a = 0; a <= 3; ++a) {
    for (int b = 0; a + b <= 3; ++b) {
      result.factor[jet_index(a, b)] =
          bu.d[a][point / (rule.degree_v + 1)] * bv.d[b][point % (rule.degree_v + 1)];
    }
  }
  return result;
}

double variable_value(const Face& face, std::size_t variable) {
  return variable < face.net.size() ? face.net[variable] : face.blend[variable - face.net.size()];
}

std::size_t variable_count(const Face& face) {
  return face.net.size() + (face.tables->rule().blend != nullptr ? 3 : 0);
}

template <class Visit>
void for_each_node(const Face& face, Visit visit) {
  const model::GaussRule &u = face.tables->rule_u(), &v = face.tables->rule_v();
  for (std::size_t kv = 0; kv < v.nodes.size(); ++kv) {
    for (std::size_t ku = 0; ku < u.nodes.size(); ++ku) {
      visit(kv * u.nodes.size() + ku, u.nodes[ku], v.nodes[kv], u.weights[ku] * v.weights[kv]);
    }
  }
}

std::vector<NodeJet<double>> node_jets(const Face& face) {
  std::vector<NodeJet<double>> jets(face.tables->rule_u().nodes.size() *
                                    face.tables->rule_v().nodes.size());
  for_each_node(face, [&](std::size_t node, double u, double v, double) {
    for (std::size_t variable = 0; variable < variable_count(face); ++variable) {
      const Influence moves = influence(face, variable, u, v);
      for (int q = 0; q < 10; ++q) {
        jets[node][q][moves.coordinate] += moves.factor[q] * variable_value(face, variable);
      }
    }
  });
  return jets;
}

/// The (a, b) derivative as a function of u and v, to first order.
template <class Real>
Point<Dual<Real>> entry(const NodeJet<Real>& jet, int a, int b) {
  Point<Dual<Real>> point;
  for (int c = 0; c < 3; ++c) {
    point[c] = {jet[jet_index(a, b)][c], jet[jet_index(a + 1, b)][c], jet[jet_index(a, b + 1)][c]};
  }
  return point;
}

template <class Real>
struct NodeCurvature {
  Dual<Real> mean, gauss;
  Real e, f, g, area;
};

template <class Real>
NodeCurvature<Real> node_curvature(const NodeJet<Real>& jet) {
  using D = Dual<Real>;
  const Point<D> su = entry(jet, 1, 0), sv = entry(jet, 0, 1);
  const D e = dot(su, su), f = dot(su, sv), g = dot(sv, sv);
  Point<D> normal = cross(su, sv);
  const D area = sqrt(dot(normal, normal));
  for (D& x : normal) x = x / area;
  const D l = dot(normal, entry(jet, 2, 0)), m = dot(normal, entry(jet, 1, 1)),
          n = dot(normal, entry(jet, 0, 2));
  const D determinant = e * g - f * f, two(2.0);
  return {(e * n - two * f * m + g * l) / (two * determinant),
          (l * n - m * m) / determinant,
          e.value,
          f.value,
          g.value,
          area.value};
}

template <class Real>
Real density(const NodeJet<Real>& jet, Energy energy) {
  const NodeCurvature<Real> c = node_curvature(jet);
  if (energy == Energy::area) return c.area;
  const Real mean = c.mean.value;
  if (energy == Energy::bending)
    return (Real(4.0) * mean * mean - Real(2.0) * c.gauss.value) * c.area;
  const Real hu = c.mean.slope[0], hv = c.mean.slope[1];
  return (c.g * hu * hu - Real(2.0) * c.f * hu * hv + c.e * hv * hv) / (c.e * c.g - c.f * c.f) *
         c.area;
}

double real_part(double x) { return x; }
double real_part(const Complex& x) { return x.real(); }

template <class Real>
Real fold_energy(const Face& face, const std::vector<NodeJet<Real>>& jets) {
  using std::sqrt;
  const double least = model::FoldOptions{}.cosine;
  Point<Real> mean{};
  for_each_node(face, [&](std::size_t node, double, double, double weight) {
    const Point<Real> normal = cross(jets[node][1], jets[node][2]);
    for (int c = 0; c < 3; ++c) mean[c] += weight * normal[c];
  });
  Real total(0.0);
  for (const NodeJet<Real>& jet : jets) {
    const Point<Real> normal = cross(jet[1], jet[2]);
    const Real missing =
        (least - dot(normal, mean) / sqrt(dot(normal, normal) * dot(mean, mean))) / (1.0 + least);
    if (real_part(missing) > 0.0) total += missing * missing * missing;
  }
  return total / static_cast<double>(jets.size());
}

template <class Real>
Real energy_of(const Face& face, const std::vector<NodeJet<Real>>& jets, Energy energy) {
  if (energy == Energy::fold) return fold_energy(face, jets);
  Real total(0.0);
  for_each_node(face, [&](std::size_t node, double, double, double weight) {
    total += weight * density(jets[node], energy);
  });
  return total;
}

}  // namespace

const char* energy_name(Energy energy) {
  constexpr const char* names[] = {"area", "bending", "variation", "fold"};
  return names[static_cast<int>(energy)];
}

double reference_energy(const Face& face, Energy energy) {
  return energy_of(face, node_jets(face), energy);
}

std::vector<double> reference_gradient(const Face& face, Energy energy) {
  const std::vector<NodeJet<double>> real = node_jets(face);
  std::vector<NodeJet<Complex>> jets(real.size());
  std::vector<double> gradient(variable_count(face));
  for (std::size_t variable = 0; variable < gradient.size(); ++variable) {
    for_each_node(face, [&](std::size_t node, double u, double v, double) {
      const Influence moves = influence(face, variable, u, v);
      for (int q = 0; q < 10; ++q) {
        for (int c = 0; c < 3; ++c) {
          jets[node][q][c] = {real[node][q][c],
                              c == moves.coordinate ? complex_step * moves.factor[q] : 0.0};
        }
      }
    });
    gradient[variable] = energy_of(face, jets, energy).imag() / complex_step;
  }
  return gradient;
}

std::vector<double> reference_jets(const Face& face) {
  const std::vector<NodeJet<double>> jets = node_jets(face);
  const std::size_t plane = jets.size();
  std::vector<double> out(30 * plane);
  for (std::size_t node = 0; node < plane; ++node) {
    for (int q = 0; q < 10; ++q) {
      for (int c = 0; c < 3; ++c) out[(3 * q + c) * plane + node] = jets[node][q][c];
    }
  }
  return out;
}

std::array<double, 2> reference_curvature(const std::vector<double>& jets, int nodes, int kv,
                                          int ku) {
  NodeJet<double> jet;
  for (int q = 0; q < 10; ++q) {
    for (int c = 0; c < 3; ++c) jet[q][c] = jets[((q * 3 + c) * nodes + kv) * nodes + ku];
  }
  const NodeCurvature<double> curvature = node_curvature(jet);
  return {curvature.mean.value, curvature.gauss.value};
}

}  // namespace bodyline::test
