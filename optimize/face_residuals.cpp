#include "optimize/face_residuals.hpp"

#include <ceres/jet.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "optimize/node_residuals.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Derivative orders (in u, in v) of the jets 1..9, in the order of model::jet_index.
constexpr int order_u[9] = {1, 0, 2, 1, 0, 3, 2, 1, 0};
constexpr int order_v[9] = {0, 1, 0, 1, 2, 0, 1, 2, 3};
constexpr int bending_jets = 5, variation_jets = 9;

// Residuals of one node and their derivatives by its jets 1..9, 3 numbers each.
struct NodeResiduals {
  int count = 0, jets = 0;
  double value[3];
  double derivative[3][3 * variation_jets];
};

template <int inputs, int outputs, class Function>
void differentiate(const double* jet, const Function& function, NodeResiduals& node) {
  using Dual = ceres::Jet<double, inputs>;
  Dual in[inputs], out[outputs];
  for (int k = 0; k < inputs; ++k) in[k] = Dual(jet[k], k);
  function(in, out);
  node.count = outputs;
  node.jets = inputs / 3;
  for (int r = 0; r < outputs; ++r) {
    node.value[r] = out[r].a;
    for (int k = 0; k < inputs; ++k) node.derivative[r][k] = out[r].v[k];
  }
}

NodeResiduals node_residuals(model::TermKind kind, const double* jet) {
  NodeResiduals node;
  if (kind == model::TermKind::bending) {
    differentiate<3 * bending_jets, 3>(
        jet, [](const auto* in, auto* out) { bending_residuals(in, out); }, node);
  } else {
    differentiate<3 * variation_jets, 2>(
        jet, [](const auto* in, auto* out) { variation_residuals(in, out); }, node);
  }
  return node;
}

// Adds d jets / d (net, blend) times the derivative by the jets of residual r to a row.
void add_row(const model::FaceRule& rule, int ku, int kv, const NodeResiduals& node, int r,
             double root, Eigen::Ref<Eigen::RowVectorXd> row) {
  const int nodes = rule.nodes, m1 = rule.degree_u + 1, n1 = rule.degree_v + 1;
  for (int q = 0; q < node.jets; ++q) {
    const double* bu = rule.basis_u + std::size_t(order_u[q]) * m1 * nodes + ku;
    const double* bv = rule.basis_v + std::size_t(order_v[q]) * n1 * nodes + kv;
    const double* slope = node.derivative[r] + 3 * q;
    for (int i = 0; i < m1; ++i) {
      for (int j = 0; j < n1; ++j) {
        const double basis = root * bu[i * nodes] * bv[j * nodes];
        for (int c = 0; c < 3; ++c) row[3 * (i * n1 + j) + c] += basis * slope[c];
      }
    }
    if (!rule.blend) continue;
    const double g = root * rule.blend[(std::size_t(q + 1) * nodes + kv) * nodes + ku];
    for (int c = 0; c < 3; ++c) row[3 * m1 * n1 + c] += g * slope[c];
  }
}

}  // namespace

FaceResiduals::FaceResiduals(const model::EvaluatorOptions& options, model::TermKind kind,
                             const model::Face& face)
    : kernels_(&model::kernels(options.isa)),
      kind_(kind),
      net_(3 * face.net),
      blend_(face.blend < 0 ? -1 : 3 * face.blend),
      tables_(std::make_unique<model::FaceTables>(face.degree_u, face.degree_v, options.nodes,
                                                  model::summed_range(face), face.blend >= 0)) {
  for (int k = 0; k < 3 * (face.degree_u + 1) * (face.degree_v + 1); ++k)
    coordinates_.push_back(net_ + k);
  for (int c = 0; blend_ >= 0 && c < 3; ++c) coordinates_.push_back(blend_ + c);
}

void FaceResiduals::at_nodes(const double* nets, double factor, VectorXd& residual,
                             MatrixXd* jacobian) const {
  const model::FaceRule& rule = tables_->rule();
  const int nodes = rule.nodes,
            jets = kind_ == model::TermKind::bending ? bending_jets : variation_jets;
  const int per_node = kind_ == model::TermKind::bending ? 3 : 2;
  std::vector<double> all(std::size_t(10) * 3 * nodes * nodes);
  kernels_->jets(rule, nets + net_, blend_ < 0 ? nullptr : nets + blend_,
                 kind_ == model::TermKind::bending ? 2 : 3, all.data());
  residual.resize(Index(nodes) * nodes * per_node);
  if (jacobian) jacobian->setZero(residual.size(), Index(coordinates_.size()));
  Eigen::RowVectorXd row_of_jacobian(coordinates_.size());
  for (int kv = 0; kv < nodes; ++kv) {
    for (int ku = 0; ku < nodes; ++ku) {
      double jet[3 * variation_jets];
      for (int q = 0; q < jets; ++q) {
        for (int c = 0; c < 3; ++c)
          jet[3 * q + c] = all[((std::size_t(q + 1) * 3 + c) * nodes + kv) * nodes + ku];
      }
      const NodeResiduals node = node_residuals(kind_, jet);
      const double root = std::sqrt(factor * rule.weights_u[ku] * rule.weights_v[kv]);
      const Index first = (Index(kv) * nodes + ku) * per_node;
      for (int r = 0; r < node.count; ++r) {
        residual[first + r] = root * node.value[r];
        if (!jacobian) continue;
        row_of_jacobian.setZero();
        add_row(rule, ku, kv, node, r, root, row_of_jacobian);
        jacobian->row(first + r) = row_of_jacobian;
      }
    }
  }
}

void FaceResiduals::evaluate(const double* nets, double factor, Eigen::Ref<VectorXd> residual,
                             MatrixXd* triangle) const {
  VectorXd full;
  MatrixXd jacobian;
  at_nodes(nets, factor, full, triangle ? &jacobian : nullptr);
  residual.setZero();
  if (!triangle) {
    residual[0] = full.norm();
    return;
  }
  // [J r] = Q [R c]: the triangle R and c have the same squares, gradient and normal matrix as J
  // and r.
  const Index columns = Index(coordinates_.size());
  MatrixXd joined(full.size(), columns + 1);
  joined.leftCols(columns) = jacobian;
  joined.col(columns) = full;
  const Eigen::HouseholderQR<MatrixXd> qr(joined);
  const Index kept = std::min<Index>(rows(), full.size());
  const MatrixXd upper = qr.matrixQR().topRows(kept).triangularView<Eigen::Upper>();
  residual.head(kept) = upper.col(columns);
  triangle->setZero(rows(), columns);
  triangle->topRows(kept) = upper.leftCols(columns);
}

}  // namespace bodyline::optimize
