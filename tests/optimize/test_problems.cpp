#include "tests/optimize/test_problems.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace bodyline::optimize {

TestProblem::TestProblem(Eigen::Index n, Value function)
    : scales(Eigen::VectorXd::Ones(n)), value_(std::move(function)) {
  const double infinity = std::numeric_limits<double>::infinity();
  within(-infinity, infinity);
}

TestProblem::TestProblem(Eigen::Index n, Eigen::Index count, Residuals function)
    : TestProblem(n, Value()) {
  residuals_ = std::move(function);
  count_ = count;
}

TestProblem& TestProblem::within(double lower, double upper) {
  lowers = Eigen::VectorXd::Constant(size(), lower);
  uppers = Eigen::VectorXd::Constant(size(), upper);
  return *this;
}

void TestProblem::note(const Eigen::VectorXd& x) {
  ++calls;
  left_bounds |= (x.array() < lowers.array()).any() || (x.array() > uppers.array()).any();
}

double TestProblem::value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  note(x);
  if (count_ == 0) return value_(x, gradient);
  Eigen::VectorXd r(count_);
  Eigen::MatrixXd jacobian(count_, size());
  residuals_(x, r, gradient != nullptr ? &jacobian : nullptr);
  if (gradient != nullptr) *gradient = 2.0 * jacobian.transpose() * r;
  return r.squaredNorm();
}

void TestProblem::residuals(const Eigen::VectorXd& x, Eigen::VectorXd& r,
                            Eigen::MatrixXd* jacobian) {
  note(x);
  residuals_(x, r, jacobian);
}

TestProblem weighted_squares(const Eigen::VectorXd& weight, const Eigen::VectorXd& target) {
  const Eigen::VectorXd root = weight.cwiseSqrt();
  return {weight.size(), weight.size(),
          [=](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
            r = root.cwiseProduct(x - target);
            if (jacobian != nullptr) *jacobian = root.asDiagonal();
          }};
}

TestProblem rosenbrock(Eigen::Index n) {
  return {n, 2 * (n - 1),
          [=](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
            if (jacobian != nullptr) jacobian->setZero();
            for (Eigen::Index i = 0; i + 1 < n; ++i) {
              r[2 * i] = 10 * (x[i + 1] - x[i] * x[i]);
              r[2 * i + 1] = 1 - x[i];
              if (jacobian == nullptr) continue;
              (*jacobian)(2 * i, i + 1) = 10;
              (*jacobian)(2 * i, i) = -20 * x[i];
              (*jacobian)(2 * i + 1, i) = -1;
            }
          }};
}

TestProblem absolute_values(const Eigen::VectorXd& target) {
  return {target.size(), [=](const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
            if (gradient != nullptr) *gradient = (x - target).cwiseSign();
            return 1.0 + (x - target).lpNorm<1>();
          }};
}

std::vector<Algorithm> all_algorithms() {
  std::vector<Algorithm> all;
  for (const std::string& name : algorithm_names()) all.push_back(algorithm_from_name(name));
  return all;
}

std::vector<Algorithm> gradient_algorithms() {
  const std::vector<Algorithm> all = all_algorithms();
  std::vector<Algorithm> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), uses_gradient);
  return chosen;
}

std::vector<Algorithm> value_algorithms() {
  const std::vector<Algorithm> all = all_algorithms();
  std::vector<Algorithm> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
               [](Algorithm algorithm) { return !uses_gradient(algorithm); });
  return chosen;
}

std::string test_name(Algorithm algorithm) {
  std::string name = algorithm_name(algorithm);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Options options_for(Algorithm algorithm) {
  Options options;
  options.algorithm = algorithm;
  return options;
}

}  // namespace bodyline::optimize
