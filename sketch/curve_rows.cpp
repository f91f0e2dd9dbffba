#include "sketch/curve_rows.hpp"

namespace bodyline::sketch {

CurveRows::CurveRows(const CurveUnknowns& unknowns, int curve, std::vector<int> besides) {
  for (int point = 0; point < unknowns.point_count(curve); ++point) {
    for (int axis = 0; axis < 3; ++axis) {
      const CurveUnknowns::Follows& follows = unknowns.follows(curve, point, axis);
      columns_.push_back(follows.unknown);
      factors_.push_back(follows.factor);
    }
  }
  columns_.insert(columns_.end(), besides.begin(), besides.end());
}

void CurveRows::add_to(NormalEquations& equations) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto count = Eigen::Index(right_.size());
  equations.add(columns_,
                Eigen::Map<const Rows>(rows_.data(), count, Eigen::Index(columns_.size())),
                Eigen::Map<const Eigen::VectorXd>(right_.data(), count));
}

}  // namespace bodyline::sketch
