#include "model/face_rule.hpp"

#include <cmath>
#include <new>
#include <numbers>
#include <stdexcept>
#include <string>

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"

namespace bodyline::model {
namespace {

constexpr std::align_val_t table_alignment{64};
constexpr int orders = 4;  // values and three derivatives
constexpr int jet_entries = 10;

struct LegendreValue {
  double value, derivative;
};

LegendreValue legendre(int n, double x) {
  double previous = 1.0, current = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
    previous = current;
    current = next;
  }
  return {current, n * (previous - x * current) / ((1.0 - x) * (1.0 + x))};
}

/// Root number k (0 is the largest) of the Legendre polynomial P_n, n >= 2.
double legendre_root(int n, int k) {
  constexpr int most_steps = 20;
  double x = std::cos(std::numbers::pi * (k + 0.75) / (n + 0.5));
  for (int step = 0; step < most_steps; ++step) {
    const LegendreValue p = legendre(n, x);
    const double correction = p.value / p.derivative;
    x -= correction;
    // Newton converges quadratically: after a step this small the next one is below rounding.
    if (std::abs(correction) < 1e-12) break;
  }
  return x;
}

/// Root number k (1 is the largest) of P_n', n >= 2.
double legendre_slope_root(int n, int k) {
  constexpr int most_steps = 20;
  double x = std::cos(std::numbers::pi * k / n);
  for (int step = 0; step < most_steps; ++step) {
    const LegendreValue p = legendre(n, x);
    // Legendre's equation gives the second derivative.
    const double second =
        (2.0 * x * p.derivative - n * (n + 1) * p.value) / ((1.0 - x) * (1.0 + x));
    const double correction = p.derivative / second;
    x -= correction;
    if (std::abs(correction) < 1e-12) break;  // as in legendre_root
  }
  return x;
}

double* write_basis(int degree, const GaussRule& gauss, double* table) {
  const int nodes = static_cast<int>(gauss.nodes.size());
  for (int k = 0; k < nodes; ++k) {
    const BernsteinJet basis = bernstein(degree, gauss.nodes[k]);
    for (int order = 0; order < orders; ++order) {
      for (int i = 0; i <= degree; ++i) {
        table[(order * (degree + 1) + i) * nodes + k] = basis.d[order][i];
      }
    }
  }
  return table + orders * (degree + 1) * nodes;
}

double* write_blend(const GaussRule& u, const GaussRule& v, double* table) {
  const int nodes = static_cast<int>(u.nodes.size());
  for (int kv = 0; kv < nodes; ++kv) {
    for (int ku = 0; ku < nodes; ++ku) {
      const std::array<double, jet_entries> g = blend_jet(u.nodes[ku], v.nodes[kv]);
      for (int q = 0; q < jet_entries; ++q) table[(q * nodes + kv) * nodes + ku] = g[q];
    }
  }
  return table + jet_entries * nodes * nodes;
}

// The mirror image acts on u in transitions between central patches, elsewhere on v.
Range summed_range(FaceKind kind, bool central) {
  if (!central) return Range::whole;
  return kind == FaceKind::transition ? Range::half_u : Range::half_v;
}

void require(bool condition, const std::string& sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

}  // namespace

GaussRule gauss_rule(int nodes, double lo, double hi) {
  require(nodes >= 1, "a Gauss rule needs at least one node, not " + std::to_string(nodes));
  GaussRule rule{std::vector<double>(nodes), std::vector<double>(nodes)};
  const double middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
  for (int k = 0; k < nodes; ++k) {
    // Only the roots on one side are computed, so that the rule is symmetric to the last bit.
    const int mirrored = std::min(k, nodes - 1 - k);
    const double root = 2 * mirrored + 1 == nodes ? 0.0 : legendre_root(nodes, mirrored);
    const double slope = legendre(nodes, root).derivative;
    rule.nodes[k] = middle + (k == mirrored ? -half : half) * root;
    rule.weights[k] = 2.0 * half / ((1.0 - root) * (1.0 + root) * slope * slope);
  }
  return rule;
}

GaussRule lobatto_rule(int nodes, double lo, double hi) {
  require(nodes >= 2, "a Lobatto rule needs at least two nodes, not " + std::to_string(nodes));
  GaussRule rule{std::vector<double>(nodes), std::vector<double>(nodes)};
  const double middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
  for (int k = 0; k < nodes; ++k) {
    const int mirrored = std::min(k, nodes - 1 - k);
    const bool in_middle = 2 * mirrored + 1 == nodes;
    const double root = mirrored == 0 ? 1.0
                        : in_middle   ? 0.0
                                      : legendre_slope_root(nodes - 1, mirrored);
    const double value = mirrored == 0 ? 1.0 : legendre(nodes - 1, root).value;
    rule.nodes[k] =
        mirrored == 0 ? (k == 0 ? lo : hi) : middle + (k == mirrored ? -half : half) * root;
    rule.weights[k] = 2.0 * half / (nodes * (nodes - 1) * value * value);
  }
  return rule;
}

Range summed_range(const Face& face) { return summed_range(face.kind, face.central); }
Range summed_range(const Surface& surface) { return summed_range(surface.kind, surface.central); }

void FaceTables::Deleter::operator()(double* p) const { ::operator delete[](p, table_alignment); }

FaceTables::FaceTables(int degree_u, int degree_v, int nodes, Range range, bool with_blend,
                       MakeRule make_rule) {
  require(nodes >= 8 && nodes <= max_nodes && nodes % 8 == 0,
          "the number of Gauss nodes is " + std::to_string(nodes) +
              "; allowed are multiples of 8 up to " + std::to_string(max_nodes));
  require(degree_u >= 1 && degree_u <= max_degree && degree_v >= 1 && degree_v <= max_degree,
          "the degrees of a face are " + std::to_string(degree_u) + " and " +
              std::to_string(degree_v) + "; allowed are 1 to " + std::to_string(max_degree));
  gauss_u_ = make_rule(nodes, 0.0, range == Range::half_u ? 0.5 : 1.0);
  gauss_v_ = make_rule(nodes, 0.0, range == Range::half_v ? 0.5 : 1.0);
  const int size = nodes * (2 + orders * (degree_u + 1 + degree_v + 1)) +
                   (with_blend ? jet_entries * nodes * nodes : 0);
  data_.reset(static_cast<double*>(::operator new[](size * sizeof(double), table_alignment)));
  double* next = data_.get();
  rule_ = {.degree_u = degree_u, .degree_v = degree_v, .nodes = nodes};
  rule_.weights_u = next;
  next = std::copy(gauss_u_.weights.begin(), gauss_u_.weights.end(), next);
  rule_.weights_v = next;
  next = std::copy(gauss_v_.weights.begin(), gauss_v_.weights.end(), next);
  rule_.basis_u = next;
  next = write_basis(degree_u, gauss_u_, next);
  rule_.basis_v = next;
  next = write_basis(degree_v, gauss_v_, next);
  if (with_blend) {
    rule_.blend = next;
    write_blend(gauss_u_, gauss_v_, next);
  }
}

}  // namespace bodyline::model
