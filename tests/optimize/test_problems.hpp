#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "optimize/minimize.hpp"

namespace bodyline::optimize {

/// A problem made of functions, that counts how often it is asked and whether it is ever asked
/// outside its bounds.
class TestProblem : public Problem {
 public:
  using Value = std::function<double(const Eigen::VectorXd&, Eigen::VectorXd*)>;
  using Residuals = std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::MatrixXd*)>;

  TestProblem(Eigen::Index n, Value function);
  /// The sum of squares of `count` residuals.
  TestProblem(Eigen::Index n, Eigen::Index count, Residuals function);

  TestProblem& within(double lower, double upper);

  Eigen::Index size() const override { return scales.size(); }
  const Eigen::VectorXd& lower() const override { return lowers; }
  const Eigen::VectorXd& upper() const override { return uppers; }
  const Eigen::VectorXd& scale() const override { return scales; }
  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override;
  bool has_residuals() const override { return count_ > 0; }
  Eigen::Index residual_count() const override { return count_; }
  void residuals(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) override;

  Eigen::VectorXd lowers, uppers, scales;
  int calls = 0;
  bool left_bounds = false;

 private:
  void note(const Eigen::VectorXd& x);

  Value value_;
  Residuals residuals_;
  Eigen::Index count_ = 0;
};

/// Sum of weight_i (x_i - target_i)^2, as a sum of squares.
TestProblem weighted_squares(const Eigen::VectorXd& weight, const Eigen::VectorXd& target);

/// Rosenbrock's chain of n variables as a sum of squares; lowest, 0, at all ones.
TestProblem rosenbrock(Eigen::Index n);

/// 1 + the sum of |x_i - target_i|: lowest on a kink.
TestProblem absolute_values(const Eigen::VectorXd& target);

std::vector<Algorithm> all_algorithms();
std::vector<Algorithm> gradient_algorithms();
std::vector<Algorithm> value_algorithms();

/// Name of a parameterized test: the algorithm's, with underscores.
std::string test_name(Algorithm algorithm);

/// Default options with this algorithm.
Options options_for(Algorithm algorithm);

}  // namespace bodyline::optimize
