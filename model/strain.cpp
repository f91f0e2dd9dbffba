#include "model/strain.hpp"

#include <cmath>

namespace bodyline::model {
namespace {

constexpr double shortest = 10.0;  // mm; legs of patches that end in a point may have no length

Eigen::Vector3d leg_between(const double* nets, int from, int to) {
  return Eigen::Map<const Eigen::Vector3d>(nets + to) -
         Eigen::Map<const Eigen::Vector3d>(nets + from);
}

}  // namespace

Strain::Strain(const BodyPlan& plan, const double* nets)
    : columns_(3 * Eigen::Index(plan.point_count)) {
  const auto add = [&](int from, int to) {
    legs_.push_back({3 * from, 3 * to, leg_between(nets, 3 * from, 3 * to), 0.0});
  };
  for (const PatchStep& patch : plan.patches) {
    const int stride = patch.degree_v + 1;
    for (int i = 0; i <= patch.degree_u; ++i) {
      for (int j = 0; j <= patch.degree_v; ++j) {
        const int at = patch.base_net + i * stride + j;
        if (i < patch.degree_u) add(at, at + stride);
        if (j < patch.degree_v) add(at, at + 1);
      }
    }
  }
  for (Leg& leg : legs_) {
    const double squared = leg.start.squaredNorm() + shortest * shortest;
    leg.weight = 1.0 / std::sqrt(double(legs_.size()) * squared);
  }
}

double Strain::value(const double* nets, double scale, double* nets_bar) {
  double sum = 0.0;
  for (const Leg& leg : legs_) {
    const double squared = leg.weight * leg.weight;
    const Eigen::Vector3d change = leg_between(nets, leg.from, leg.to) - leg.start;
    sum += squared * change.squaredNorm();
    if (!nets_bar) continue;
    const Eigen::Vector3d bar = 2.0 * scale * squared * change;
    Eigen::Map<Eigen::Vector3d>(nets_bar + leg.to) += bar;
    Eigen::Map<Eigen::Vector3d>(nets_bar + leg.from) -= bar;
  }
  return sum;
}

void Strain::residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Index row = 0;
  for (const Leg& leg : legs_) {
    r.segment<3>(row) = leg.weight * (leg_between(nets, leg.from, leg.to) - leg.start);
    for (int c = 0; c < 3; ++c, ++row) {
      entries.emplace_back(row, leg.to + c, leg.weight);
      entries.emplace_back(row, leg.from + c, -leg.weight);
    }
  }
  if (!jacobian) return;
  jacobian->resize(residual_count(), columns_);
  jacobian->setFromTriplets(entries.begin(), entries.end());
}

}  // namespace bodyline::model
