#include "optimize/net_rows.hpp"

#include <algorithm>

namespace bodyline::optimize {

double NetRow::at(const double* nets) const {
  double sum = offset;
  for (const auto& [number, slope] : slopes) sum += slope * nets[number];
  return sum;
}

double NetRow::excess(double value) const { return value - std::clamp(value, lower, upper); }

NetRows::NetRows(const model::BodyPlan& plan, model::Stage stage)
    : stage_(stage), columns_(3 * Eigen::Index(plan.point_count)) {}

double NetRows::value(const double* nets, double scale, double* nets_bar) {
  double sum = 0.0;
  for (const NetRow& row : rows_) {
    const double excess = row.excess(row.at(nets));
    sum += excess * excess;
    if (!nets_bar) continue;
    for (const auto& [number, slope] : row.slopes) nets_bar[number] += 2.0 * scale * excess * slope;
  }
  return sum;
}

void NetRows::residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    r[Eigen::Index(k)] = rows_[k].excess(rows_[k].at(nets));
    if (r[Eigen::Index(k)] == 0.0) continue;
    for (const auto& [number, slope] : rows_[k].slopes) entries.emplace_back(k, number, slope);
  }
  if (!jacobian) return;
  jacobian->resize(residual_count(), columns_);
  jacobian->setFromTriplets(entries.begin(), entries.end());
}

}  // namespace bodyline::optimize
