#include "sketch/speed_tolerance.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace bodyline::sketch {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Which tolerances are tried: each this many times the one before.
// The least is what curves of cars of one kind differ by that lines show in space.
constexpr double least_tolerance = 1e-3, largest_tolerance = 0.3, step = 1.7782794100389228;

// Twice the logarithm of how common a tolerance is before anything is known: most curves run much
// like those of the template, so a greater one must be told by more than chance.
double prior_of(double tolerance) { return -2.0 * std::log(tolerance); }

using Factors = Eigen::LDLT<MatrixXd>;

bool is_positive_definite(const Factors& factors) {
  return factors.info() == Eigen::Success && (factors.vectorD().array() > 0.0).all();
}

double log_determinant(const Factors& factors) { return factors.vectorD().array().log().sum(); }

MatrixXd part(const NormalEquations& equations, const std::vector<int>& columns) {
  return equations.matrix()(columns, columns);
}
VectorXd right_part(const NormalEquations& equations, const std::vector<int>& columns) {
  return equations.right()(columns);
}

// The columns from `first` on that the template or a line holds.
std::vector<int> held_columns(const CurveKnowledge& knowledge, int first, int last) {
  std::vector<int> columns;
  for (int k = first; k < last; ++k) {
    if (knowledge.lines.matrix()(k, k) + knowledge.shape.matrix()(k, k) > 0.0) columns.push_back(k);
  }
  return columns;
}

}  // namespace

double likely_speed_tolerance(const CurveKnowledge& knowledge) {
  const int all = int(knowledge.lines.right().size());
  std::vector<int> columns = held_columns(knowledge, 0, knowledge.curve_unknowns);
  const auto curve_count = Eigen::Index(columns.size());
  for (const int column : held_columns(knowledge, knowledge.curve_unknowns, all))
    columns.push_back(column);
  const MatrixXd lines = part(knowledge.lines, columns), shape = part(knowledge.shape, columns),
                 speed = part(knowledge.speed, columns);
  const VectorXd lines_right = right_part(knowledge.lines, columns),
                 shape_right = right_part(knowledge.shape, columns),
                 speed_right = right_part(knowledge.speed, columns);
  double best = least_tolerance, most = -INFINITY;
  for (double tolerance = least_tolerance; tolerance <= largest_tolerance; tolerance *= step) {
    const double weight = 1.0 / (tolerance * tolerance);
    const MatrixXd sum = shape + weight * speed;
    const Factors prior(sum.topLeftCorner(curve_count, curve_count)), posterior(lines + sum);
    if (!is_positive_definite(prior) || !is_positive_definite(posterior)) continue;
    const VectorXd right = lines_right + shape_right + weight * speed_right;
    const double least_sum = knowledge.lines.sum() + knowledge.shape.sum() +
                             weight * knowledge.speed.sum() - right.dot(posterior.solve(right));
    const double evidence =
        log_determinant(prior) - log_determinant(posterior) - least_sum + prior_of(tolerance);
    if (evidence > most) most = evidence, best = tolerance;
  }
  return best;
}

}  // namespace bodyline::sketch
