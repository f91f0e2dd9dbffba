#include "optimize/hard_point_target.hpp"

#include <cmath>
#include <stdexcept>

#include "model/bernstein.hpp"
#include "optimize/bounded_target.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {
namespace {

model::Scan positions(const std::vector<HardPoint>& points) {
  model::Scan scan;
  for (const HardPoint& point : points) scan.points.push_back(point.point);
  return scan;
}

class HardPointTarget : public BoundedTarget {
 public:
  HardPointTarget(const model::BodyPlan& plan, model::Stage stage, std::vector<HardPoint> points)
      : BoundedTarget(plan, stage),
        faces_(&plan.faces(stage)),
        points_(std::move(points)),
        positions_(positions(points_)),
        matcher_(plan, stage, positions_) {}
  std::string name() const override { return "hard points"; }

 private:
  std::vector<NetRow> measure(const double* nets) override;

  const std::vector<model::Face>* faces_;
  std::vector<HardPoint> points_;
  model::Scan positions_;
  ScanMatcher matcher_;
};

// The signed distance of a point from the tangent plane at its foot, outside positive, with the
// foot and the normal held.
NetRow distance_row(const model::Face& face, const Match& match, const Eigen::Vector3d& normal,
                    const double* nets) {
  const auto in_u = model::bernstein(face.degree_u, match.u);
  const auto in_v = model::bernstein(face.degree_v, match.v);
  NetRow row;
  row.offset = match.distance;
  for (int i = 0; i <= face.degree_u; ++i) {
    for (int j = 0; j <= face.degree_v; ++j) {
      const double weight = in_u.d[0][i] * in_v.d[0][j];
      for (int axis = 0; axis < 3; ++axis) {
        const int number = 3 * (face.net + i * (face.degree_v + 1) + j) + axis;
        row.slopes.push_back({number, -weight * normal[axis]});
        row.offset += weight * normal[axis] * nets[number];
      }
    }
  }
  return row;
}

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
    if (points_[k].rule != HardPointRule::outside) row.upper = -points_[k].margin;
    if (points_[k].rule != HardPointRule::inside) row.lower = points_[k].margin;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

FitTargetMaker hard_point_target(const std::vector<HardPoint>& points) {
  std::vector<HardPoint> folded = points;
  for (HardPoint& point : folded) {
    if (!point.point.allFinite() || !std::isfinite(point.margin) || point.margin < 0.0)
      throw std::invalid_argument("hard points must be finite and their margins not negative");
    if (point.rule == HardPointRule::through) point.margin = 0.0;
    point.point.y() = -std::abs(point.point.y());
  }
  return [folded](const model::BodyPlan& plan, model::Stage stage, FitDetail) {
    return std::make_unique<HardPointTarget>(plan, stage, folded);
  };
}

}  // namespace bodyline::optimize
