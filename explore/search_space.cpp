#include "explore/search_space.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::explore {

SearchSpace::SearchSpace(const DesignSpace& space) : space_(&space) {
  weights_ = int(std::count_if(space.columns().begin(), space.columns().end(),
                               [](const Column& c) { return c.kind == ColumnKind::weight; }));
}

void SearchSpace::values(const Eigen::VectorXd& point, std::span<double> values) const {
  double rest = 1.0;
  for (int k = 0; k + 1 < weights_; ++k) {
    values[k] = rest * point[k];
    rest -= values[k];
  }
  if (weights_ > 0) values[weights_ - 1] = rest;
  const int skipped = weights_ > 0 ? 1 : 0;
  for (int k = weights_; k < space_->column_count(); ++k) {
    const Column& column = space_->columns()[k];
    const double t = point[k - skipped];
    values[k] = column.kind == ColumnKind::choice
                    ? std::min(std::floor(t * (column.upper + 1.0)), column.upper)
                    : column.lower + t * (column.upper - column.lower);
  }
}

void SearchSpace::pullback(const Eigen::VectorXd& point, std::span<const double> values_bar,
                           Eigen::Ref<Eigen::VectorXd> point_bar) const {
  // Backwards through rest[k + 1] = rest[k] (1 - t[k]) and weight[k] = rest[k] t[k].
  std::vector<double> rest(std::size_t(weights_) + 1, 1.0);
  for (int k = 0; k + 1 < weights_; ++k) rest[k + 1] = rest[k] * (1.0 - point[k]);
  double rest_bar = weights_ > 0 ? values_bar[weights_ - 1] : 0.0;
  for (int k = weights_ - 2; k >= 0; --k) {
    point_bar[k] = rest[k] * (values_bar[k] - rest_bar);
    rest_bar = point[k] * values_bar[k] + (1.0 - point[k]) * rest_bar;
  }
  const int skipped = weights_ > 0 ? 1 : 0;
  for (int k = weights_; k < space_->column_count(); ++k) {
    const Column& column = space_->columns()[k];
    point_bar[k - skipped] =
        column.kind == ColumnKind::choice ? 0.0 : (column.upper - column.lower) * values_bar[k];
  }
}

Eigen::VectorXd SearchSpace::point(std::span<const double> values) const {
  Eigen::VectorXd result(size());
  double rest = 1.0;
  for (int k = 0; k + 1 < weights_; ++k) {
    result[k] = rest > 0.0 ? std::clamp(values[k] / rest, 0.0, 1.0) : 0.0;
    rest -= values[k];
  }
  const int skipped = weights_ > 0 ? 1 : 0;
  for (int k = weights_; k < space_->column_count(); ++k) {
    const Column& column = space_->columns()[k];
    result[k - skipped] =
        column.kind == ColumnKind::choice
            ? (values[k] + 0.5) / (column.upper + 1.0)
            : std::clamp((values[k] - column.lower) / (column.upper - column.lower), 0.0, 1.0);
  }
  return result;
}

std::vector<double> SearchSpace::rounded(const Eigen::VectorXd& point) const {
  std::vector<double> exact(std::size_t(space_->column_count()), 0.0), result = exact;
  std::vector<double> cube(std::size_t(size()), 0.0);
  values(point, exact);
  space_->point(exact, cube);
  space_->values(cube, result);
  return result;
}

}  // namespace bodyline::explore
