#include "sketch/normal_equations.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace bodyline::sketch {

NormalEquations::NormalEquations(int count)
    : matrix_(Eigen::MatrixXd::Zero(count, count)), right_(Eigen::VectorXd::Zero(count)) {}

void NormalEquations::add(std::span<const int> columns,
                          const Eigen::Ref<const Eigen::MatrixXd>& rows,
                          const Eigen::VectorXd& right) {
  const Eigen::MatrixXd square = rows.transpose() * rows;
  const Eigen::VectorXd product = rows.transpose() * right;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] < 0) continue;
    right_[columns[i]] -= product[Eigen::Index(i)];
    for (std::size_t j = 0; j < columns.size(); ++j)
      if (columns[j] >= 0)
        matrix_(columns[i], columns[j]) += square(Eigen::Index(i), Eigen::Index(j));
  }
  sum_ += right.squaredNorm();
}

Eigen::VectorXd NormalEquations::solution(double damping) const {
  // Each unknown in units in which its own square counts 1.
  const Eigen::VectorXd unit = matrix_.diagonal().unaryExpr(
      [](double square) { return square > 0.0 ? 1.0 / std::sqrt(square) : 1.0; });
  Eigen::MatrixXd matrix = unit.asDiagonal() * matrix_ * unit.asDiagonal();
  for (Eigen::Index k = 0; k < matrix.rows(); ++k)
    matrix(k, k) = (matrix(k, k) > 0.0 ? matrix(k, k) : 1.0) + damping;
  return unit.cwiseProduct(matrix.ldlt().solve(unit.cwiseProduct(right_)));
}

}  // namespace bodyline::sketch
