#include "strokes/carrier_equations.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>

namespace bodyline::strokes {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixX3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int nodes = 3;  // of Gauss's rule, per direction of a cell
constexpr double node[nodes] = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr double node_weight[nodes] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
// Of the displacement's energy outside of the domain: without it functions of which hardly anything
// lies inside would be free.
constexpr double outside_share = 1e-4;
// What is added to the diagonal, of its mean.
constexpr double ridge = 1e-13;

using Block = Eigen::Matrix<double, CarrierBasis::at_once, CarrierBasis::at_once>;

/// Squared ratio of the extents in t and in s: how long the base's isolines are on the average.
double squared_aspect(const SurfaceFunction& base, const Polygon& domain) {
  constexpr int lines = 8;
  double in_s = 0.0, in_t = 0.0;
  for (int i = 0; i < lines; ++i) {
    for (int j = 0; j < lines; ++j) {
      const Vector2d place((i + 0.5) / lines, (j + 0.5) / lines);
      if (depth(domain, place) < 0.0) continue;
      const PatchJet jet = base(place);
      in_s += jet.s.norm();
      in_t += jet.t.norm();
    }
  }
  return in_s > 0.0 && in_t > 0.0 ? in_t * in_t / (in_s * in_s) : 1.0;
}

}  // namespace

void CarrierEquations::Stencil::add(const CarrierBasis& basis,
                                    const std::array<int, CarrierBasis::at_once>& index,
                                    const Block& block) {
  const int row = basis.per_direction();
  for (int a = 0; a < CarrierBasis::at_once; ++a) {
    for (int b = 0; b < CarrierBasis::at_once; ++b) {
      if (index[b] < index[a]) continue;
      const int rows = index[b] / row - index[a] / row, columns = index[b] % row - index[a] % row;
      entries((rows + reach) * width + columns + reach, index[a]) += block(a, b);
    }
  }
}

CarrierEquations::CarrierEquations(SurfaceFunction base, CarrierBasis basis, Fair fair)
    : base_(std::move(base)),
      basis_(std::move(basis)),
      energy_(basis_.count()),
      data_(basis_.count()),
      energy_right_(MatrixX3d::Zero(basis_.count(), 3)),
      data_right_(MatrixX3d::Zero(basis_.count(), 3)) {
  add_energy(fair);
}

void CarrierEquations::add_energy(Fair fair) {
  const double a = squared_aspect(base_, basis_.domain), cell = 1.0 / basis_.cells;
  const Vector3d scale(a, 2.0, 1.0 / a);
  for (int i = 0; i < basis_.cells; ++i) {
    for (int j = 0; j < basis_.cells; ++j) {
      Block block = Block::Zero();
      CarrierBasis::Row row;
      for (int k = 0; k < nodes * nodes; ++k) {
        const int in_s = k / nodes, in_t = k % nodes;
        const Vector2d place((i + node[in_s]) * cell, (j + node[in_t]) * cell);
        row = basis_.row(place);
        const auto bends = row.jet.bottomRows<3>();
        const bool inside = depth(basis_.domain, place) >= 0.0;
        const Vector3d weight = (inside ? 1.0 : outside_share) * node_weight[in_s] *
                                node_weight[in_t] * cell * cell * scale;
        block += bends.transpose() * weight.asDiagonal() * bends;
        if (!inside || fair == Fair::displacement) continue;
        const PatchJet jet = base_(place);
        Matrix3d of_base;
        of_base << jet.ss.transpose(), jet.st.transpose(), jet.tt.transpose();
        const Eigen::Matrix<double, CarrierBasis::at_once, 3> right =
            bends.transpose() * weight.asDiagonal() * of_base;
        for (int f = 0; f < CarrierBasis::at_once; ++f)
          energy_right_.row(row.index[f]) -= right.row(f);
      }
      energy_.add(basis_, row.index, block);
    }
  }
}

void CarrierEquations::set_samples(const std::vector<CarrierSample>& samples) {
  data_.entries.setZero();
  data_right_.setZero();
  for (const CarrierSample& sample : samples) {
    const CarrierBasis::Row row = basis_.row(sample.place);
    const auto values = row.jet.row(0);
    data_.add(basis_, row.index, sample.weight * values.transpose() * values);
    const Vector3d missing = sample.weight * (sample.point - base_(sample.place).point);
    for (int f = 0; f < CarrierBasis::at_once; ++f)
      data_right_.row(row.index[f]) += values[f] * missing.transpose();
  }
}

std::optional<Carrier> CarrierEquations::solve(double fairness) const {
  const int count = basis_.count(), row = basis_.per_direction();
  const Eigen::MatrixXd entries = data_.entries + fairness * energy_.entries;
  constexpr int own = Stencil::reach * Stencil::width + Stencil::reach;
  const double least = ridge * entries.row(own).mean();
  Eigen::SparseMatrix<double> lower(count, count);
  lower.reserve(Eigen::VectorXi::Constant(count, Stencil::width * (Stencil::reach + 1)));
  for (int f = 0; f < count; ++f) {
    lower.insert(f, f) = entries(own, f) + least;
    for (int k = own + 1; k < Stencil::width * Stencil::width; ++k) {
      const int other =
          f + (k / Stencil::width - Stencil::reach) * row + k % Stencil::width - Stencil::reach;
      if (entries(k, f) != 0.0) lower.insert(other, f) = entries(k, f);
    }
  }
  lower.makeCompressed();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors(lower);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const MatrixX3d coefficients = factors.solve(data_right_ + fairness * energy_right_);
  if (!coefficients.allFinite()) return std::nullopt;
  return Carrier(base_, basis_, coefficients);
}

}  // namespace bodyline::strokes
