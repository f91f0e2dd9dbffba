#include "optimize/energy_residuals.hpp"

#include <ceres/jet.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "model/face_rule.hpp"
#include "optimize/node_residuals.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Every face counts twice: side faces for their mirror images, central ones because their left half
// is summed.
constexpr double both_halves = 2.0;

// One energy on one face: its rows in the residual vector and its quadrature.
struct Block {
  model::TermKind kind;
  double weight;
  int term;
  const model::Face* face;
  std::unique_ptr<model::FaceTables> tables;
  Index first_row = 0, coordinates = 0, rows = 0;  // rows = coordinates + 1
};

model::Range range_of(const model::Face& face) {
  if (!face.central) return model::Range::whole;
  return face.central_along_u ? model::Range::half_u : model::Range::half_v;
}

bool is_energy(model::TermKind kind) {
  return kind == model::TermKind::bending || kind == model::TermKind::variation;
}

// Residuals of one node and their derivatives with respect to its jet (`inputs` numbers).
template <int inputs, int outputs, class Function>
void differentiate(const double* jet, const Function& function, double* value, double* derivative) {
  using Dual = ceres::Jet<double, inputs>;
  Dual in[inputs], out[outputs];
  for (int k = 0; k < inputs; ++k) in[k] = Dual(jet[k], k);
  function(in, out);
  for (int r = 0; r < outputs; ++r) {
    value[r] = out[r].a;
    for (int k = 0; k < inputs; ++k) derivative[r * inputs + k] = out[r].v[k];
  }
}

// Derivative orders (in u, in v) of the jets 1..9, in the order of model::jet_index.
constexpr int order_u[9] = {1, 0, 2, 1, 0, 3, 2, 1, 0};
constexpr int order_v[9] = {0, 1, 0, 1, 2, 0, 1, 2, 3};

// Full residuals of a face, nodes * per_node rows, and their Jacobian with respect to its net (and
// blend).
void face_residuals(const Block& block, const model::Kernels& kernels, const double* net,
                    const double* blend, double factor, VectorXd& residual, MatrixXd* jacobian) {
  const model::FaceRule& rule = block.tables->rule();
  const int nodes = rule.nodes, n1 = rule.degree_v + 1, m1 = rule.degree_u + 1;
  const bool bending = block.kind == model::TermKind::bending;
  const int per_node = bending ? 3 : 2, jets = bending ? 5 : 9;
  std::vector<double> all(std::size_t(10) * 3 * nodes * nodes);
  kernels.jets(rule, net, blend, bending ? 2 : 3, all.data());
  residual.resize(Index(nodes) * nodes * per_node);
  if (jacobian) jacobian->setZero(residual.size(), block.coordinates);
  for (int kv = 0; kv < nodes; ++kv) {
    for (int ku = 0; ku < nodes; ++ku) {
      double jet[27], value[3], derivative[3 * 27];
      for (int q = 0; q < jets; ++q) {
        for (int c = 0; c < 3; ++c)
          jet[3 * q + c] = all[((std::size_t(q + 1) * 3 + c) * nodes + kv) * nodes + ku];
      }
      if (bending) {
        differentiate<15, 3>(
            jet, [](const auto* in, auto* out) { bending_residuals(in, out); }, value, derivative);
      } else {
        differentiate<27, 2>(
            jet, [](const auto* in, auto* out) { variation_residuals(in, out); }, value,
            derivative);
      }
      const double root = std::sqrt(factor * rule.weights_u[ku] * rule.weights_v[kv]);
      const Index row = (Index(kv) * nodes + ku) * per_node;
      for (int r = 0; r < per_node; ++r) residual[row + r] = root * value[r];
      if (!jacobian) continue;
      for (int q = 0; q < jets; ++q) {
        const double* bu = rule.basis_u + std::size_t(order_u[q]) * m1 * nodes + ku;
        const double* bv = rule.basis_v + std::size_t(order_v[q]) * n1 * nodes + kv;
        for (int r = 0; r < per_node; ++r) {
          const double* slope = derivative + (r * jets + q) * 3;
          for (int i = 0; i < m1; ++i) {
            for (int j = 0; j < n1; ++j) {
              const double basis = root * bu[i * nodes] * bv[j * nodes];
              for (int c = 0; c < 3; ++c)
                (*jacobian)(row + r, 3 * (i * n1 + j) + c) += basis * slope[c];
            }
          }
          if (!rule.blend) continue;
          const double g = root * rule.blend[(std::size_t(q + 1) * nodes + kv) * nodes + ku];
          for (int c = 0; c < 3; ++c) (*jacobian)(row + r, 3 * m1 * n1 + c) += g * slope[c];
        }
      }
    }
  }
}

}  // namespace

struct EnergyResiduals::State {
  explicit State(model::Evaluator& given);
  void add_blocks(int term);
  MatrixXd net_jacobian(const Block& block);
  void evaluate_block(const Block& block, double factor, VectorXd& residual, MatrixXd* jacobian);
  void evaluate_roots(const VectorXd& x, VectorXd& residual, MatrixXd* jacobian);
  std::unique_ptr<model::Evaluator> single_term(const model::Term& term) const;

  model::Evaluator* evaluator;
  std::vector<Block> blocks;
  // Terms that are one square root each, and the area that multiplies the variation; each alone
  // with weight 1.
  std::vector<std::pair<double, std::unique_ptr<model::Evaluator>>> roots;
  std::unique_ptr<model::Evaluator> area;
  Index rows = 0;
};

std::unique_ptr<model::Evaluator> EnergyResiduals::State::single_term(
    const model::Term& term) const {
  model::EvaluatorOptions options = evaluator->options();
  options.terms = {term};
  options.terms.front().weight = 1.0;
  return std::make_unique<model::Evaluator>(evaluator->shared_context(), evaluator->selected(),
                                            options);
}

EnergyResiduals::State::State(model::Evaluator& given) : evaluator(&given) {
  const std::vector<model::Term>& terms = given.options().terms;
  for (int t = 0; t < int(terms.size()); ++t) {
    if (terms[t].weight < 0.0) {
      throw std::invalid_argument("the weight of " + model::term_name(terms[t].kind) +
                                  " is negative; a sum of squares needs weights of 0 or more");
    }
    if (is_energy(terms[t].kind)) {
      add_blocks(t);
    } else {
      roots.emplace_back(terms[t].weight, single_term(terms[t]));
    }
    if (terms[t].kind == model::TermKind::variation) {
      area = single_term({model::TermKind::area, 1.0, terms[t].stage, {}});
    }
  }
  for (Block& block : blocks) {
    block.first_row = rows;
    rows += block.rows;
  }
  rows += Index(roots.size());
}

void EnergyResiduals::State::add_blocks(int term_index) {
  const model::Term& term = evaluator->options().terms[term_index];
  for (const model::Face& face : evaluator->context().plan.faces(term.stage)) {
    const bool chosen =
        term.faces.empty() || std::any_of(term.faces.begin(), term.faces.end(), [&](const auto& p) {
          return model::name_matches(p, face.name);
        });
    if (!chosen) continue;
    Block block{term.kind, term.weight, term_index, &face, nullptr};
    block.tables = std::make_unique<model::FaceTables>(
        face.degree_u, face.degree_v, evaluator->options().nodes, range_of(face), face.blend >= 0);
    block.coordinates = 3 * (face.degree_u + 1) * (face.degree_v + 1) + (face.blend >= 0 ? 3 : 0);
    block.rows = block.coordinates + 1;
    blocks.push_back(std::move(block));
  }
}

// d (net, blend) / d variables, one row per coordinate, by the pullback of unit adjoints.
MatrixXd EnergyResiduals::State::net_jacobian(const Block& block) {
  MatrixXd jacobian(block.coordinates, evaluator->size());
  std::vector<double> bar(3 * std::size_t(evaluator->context().plan.point_count), 0.0);
  VectorXd row(evaluator->size());
  const Index net_coordinates = 3 * (block.face->degree_u + 1) * (block.face->degree_v + 1);
  for (Index k = 0; k < block.coordinates; ++k) {
    const Index at =
        k < net_coordinates ? 3 * block.face->net + k : 3 * block.face->blend + k - net_coordinates;
    bar[at] = 1.0;
    evaluator->build_pullback(bar, row);
    bar[at] = 0.0;
    jacobian.row(k) = row.transpose();
  }
  return jacobian;
}

void EnergyResiduals::State::evaluate_block(const Block& block, double factor, VectorXd& residual,
                                            MatrixXd* jacobian) {
  const double* net = evaluator->nets() + 3 * block.face->net;
  const double* blend =
      block.face->blend >= 0 ? evaluator->nets() + 3 * block.face->blend : nullptr;
  VectorXd full;
  MatrixXd full_jacobian;
  face_residuals(block, model::kernels(evaluator->options().isa), net, blend, factor, full,
                 jacobian ? &full_jacobian : nullptr);
  auto own = residual.segment(block.first_row, block.rows);
  own.setZero();
  if (!jacobian) {
    own[0] = full.norm();
    return;
  }
  // [J r] = Q [R c]: the triangle R and c have the same squares, gradient and normal matrix as J
  // and r.
  MatrixXd joined(full.size(), block.coordinates + 1);
  joined.leftCols(block.coordinates) = full_jacobian;
  joined.col(block.coordinates) = full;
  const Eigen::HouseholderQR<MatrixXd> qr(joined);
  const Index kept = std::min<Index>(block.rows, full.size());
  MatrixXd triangle = qr.matrixQR().topRows(kept).triangularView<Eigen::Upper>();
  own.head(kept) = triangle.col(block.coordinates);
  jacobian->middleRows(block.first_row, block.rows).setZero();
  jacobian->middleRows(block.first_row, kept).noalias() =
      triangle.leftCols(block.coordinates) * net_jacobian(block);
}

void EnergyResiduals::State::evaluate_roots(const VectorXd& x, VectorXd& residual,
                                            MatrixXd* jacobian) {
  Index row = rows - Index(roots.size());
  VectorXd gradient(evaluator->size());
  for (auto& [weight, single] : roots) {
    const double value = single->evaluate(x, jacobian ? &gradient : nullptr);
    residual[row] = std::sqrt(weight * value);
    if (jacobian) {
      if (residual[row] > 0.0) {
        jacobian->row(row) = (0.5 * weight / residual[row]) * gradient.transpose();
      } else {
        jacobian->row(row).setZero();
      }
    }
    ++row;
  }
}

EnergyResiduals::EnergyResiduals(model::Evaluator& evaluator)
    : state_(std::make_unique<State>(evaluator)) {}
EnergyResiduals::~EnergyResiduals() = default;

Eigen::Index EnergyResiduals::count() const { return state_->rows; }

void EnergyResiduals::evaluate(const VectorXd& x, VectorXd& residual, MatrixXd* jacobian) {
  State& s = *state_;
  s.evaluator->build(x);
  double area = 1.0;
  VectorXd area_gradient(s.evaluator->size());
  // The area term is in m^2, the variation in 1/mm^2.
  if (s.area) area = 1e6 * s.area->evaluate(x, jacobian ? &area_gradient : nullptr);
  for (const Block& block : s.blocks) {
    const bool variation = block.kind == model::TermKind::variation;
    s.evaluate_block(block, both_halves * block.weight * (variation ? area : 1.0), residual,
                     jacobian);
    if (!variation || !jacobian) continue;
    // r = sqrt(area) rho: the area's own derivative.
    jacobian->middleRows(block.first_row, block.rows) +=
        (0.5e6 / area) * residual.segment(block.first_row, block.rows) * area_gradient.transpose();
  }
  s.evaluate_roots(x, residual, jacobian);
}

}  // namespace bodyline::optimize
