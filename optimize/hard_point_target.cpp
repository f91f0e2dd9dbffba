#include "optimize/hard_point_target.hpp"

#include <cmath>
#include <stdexcept>

#include "model/largest_coordinate.hpp"
#include "optimize/bounded_target.hpp"
#include "optimize/distance_row.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {
namespace {

model::Scan positions(const std::vector<model::HardPoint>& points) {
  model::Scan scan;
  for (const model::HardPoint& point : points) scan.points.push_back(point.point);
  return scan;
}

class HardPointTarget : public BoundedTarget {
 public:
  HardPointTarget(const model::BodyPlan& plan, model::Stage stage,
                  std::vector<model::HardPoint> points)
      : BoundedTarget(plan, stage),
        faces_(&plan.faces(stage)),
        points_(std::move(points)),
        positions_(positions(points_)),
        matcher_(plan, stage, positions_) {}

 private:
  std::vector<NetRow> measure(const double* nets) override;

  const std::vector<model::Face>* faces_;
  std::vector<model::HardPoint> points_;
  model::Scan positions_;
  ScanMatcher matcher_;
};

std::vector<NetRow> HardPointTarget::measure(const double* nets) {
  const std::vector<Match> matches = matcher_.match(nets);
  std::vector<NetRow> rows;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const Match& match = matches[k];
    // Beyond a rim the way to the point is not along the normal.
    const Eigen::Vector3d way = points_[k].point - match.foot;
    const Eigen::Vector3d normal =
        way.norm() > 1e-6 ? Eigen::Vector3d(way / match.distance) : match.normal;
    NetRow row = distance_row((*faces_)[match.face], match, normal, nets);
    if (points_[k].rule != model::HardPointRule::outside) row.upper = -points_[k].margin;
    if (points_[k].rule != model::HardPointRule::inside) row.lower = points_[k].margin;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

FitTargetMaker hard_point_target(const std::vector<model::HardPoint>& points) {
  std::vector<model::HardPoint> folded = points;
  for (model::HardPoint& point : folded) {
    if (!(point.point.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= model::largest_coordinate)) {
      throw std::invalid_argument(
          "the coordinates of a hard point must be finite and lie within 1 km");
    }
    if (!(point.margin >= 0.0 && point.margin <= model::largest_coordinate)) {
      throw std::invalid_argument("the margin of a hard point must not be negative, nor over 1 km");
    }
    if (point.rule == model::HardPointRule::through) point.margin = 0.0;
    point.point.y() = -std::abs(point.point.y());
  }
  return [folded](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<HardPointTarget>(plan, stage, folded);
  };
}

}  // namespace bodyline::optimize
