#pragma once

#include <Eigen/Core>
#include <span>

namespace bodyline::sketch {

/// Linear least squares, gathered as normal equations.
class NormalEquations {
 public:
  explicit NormalEquations(int count);

  /// Adds the squares of rows * x[columns] + right. An unknown may stand in several columns; a
  /// column of -1 is left out.
  void add(std::span<const int> columns, const Eigen::Ref<const Eigen::MatrixXd>& rows,
           const Eigen::VectorXd& right);

  /// The sum of all squares at x = 0.
  double sum() const { return sum_; }
  /// The sum at x is sum() - 2 right . x + x . matrix x.
  const Eigen::MatrixXd& matrix() const { return matrix_; }
  const Eigen::VectorXd& right() const { return right_; }

  /// Where the sum of all squares is least, when moves cost `damping` times what they cost already,
  /// unknown by unknown (Levenberg and Marquardt). Unknowns that no row holds are 0.
  Eigen::VectorXd solution(double damping = 0.0) const;

 private:
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_;
  double sum_ = 0.0;
};

}  // namespace bodyline::sketch
