#include "sketch/curve_unknowns.hpp"

#include "model/variables.hpp"

namespace bodyline::sketch {

CurveUnknowns::CurveUnknowns(const model::Model& model) {
  const model::VariableMap map(model, model::connect(model));
  const Eigen::VectorXd given = model::to_parameters(model, map.layout());
  std::vector<Follows> by_parameter(std::size_t(map.layout().size()));
  for (int p = 0; p < map.layout().size(); ++p) by_parameter[p].offset = given[p];
  for (const model::Variable& variable : map.variables()) {
    if (variable.kind != model::ParameterKind::curve) continue;
    for (const model::Tie& tie : variable.ties)
      by_parameter[tie.parameter] = {count_, tie.factor, tie.offset};
    ++count_;
  }
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    follows_.emplace_back();
    for (std::size_t i = 0; i < model.curves[c].points.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        follows_.back().push_back(by_parameter[map.layout().point(int(c), int(i)) + axis]);
  }
}

std::vector<Eigen::Vector3d> CurveUnknowns::points(int curve,
                                                   const Eigen::VectorXd& unknowns) const {
  const std::vector<Follows>& coordinates = follows_[curve];
  std::vector<Eigen::Vector3d> points(coordinates.size() / 3);
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const auto& [unknown, factor, offset] = coordinates[k];
    points[k / 3][Eigen::Index(k % 3)] = unknown < 0 ? offset : factor * unknowns[unknown] + offset;
  }
  return points;
}

Eigen::VectorXd CurveUnknowns::means(const std::vector<std::vector<Eigen::Vector3d>>& points,
                                     const std::vector<double>& weights) const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(count_), total = sums;
  for (std::size_t c = 0; c < follows_.size(); ++c) {
    for (std::size_t k = 0; k < follows_[c].size(); ++k) {
      const auto& [unknown, factor, offset] = follows_[c][k];
      if (unknown < 0) continue;
      sums[unknown] += weights[c] * (points[c][k / 3][Eigen::Index(k % 3)] - offset) / factor;
      total[unknown] += weights[c];
    }
  }
  return sums.cwiseQuotient(total);
}

void CurveUnknowns::write(const Eigen::VectorXd& unknowns, model::Model& model) const {
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    model.curves[c].points = points(int(c), unknowns);
}

}  // namespace bodyline::sketch
