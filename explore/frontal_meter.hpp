#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "explore/box_meter.hpp"
#include "model/body_plan.hpp"

namespace bodyline::explore {

/// The area of the outline seen from the front, m^2, taken as open nowhere between its left and
/// right side: at each of 512 heights the body is as wide as its widest point. Faces are seen as
/// polygons of 16 x 16 cells, so that it is true to about 1e-3 of itself.
class FrontalMeter {
 public:
  /// `plan` must outlive it.
  explicit FrontalMeter(const model::BodyPlan& plan);
  double measure(const double* nets, const BodyReach& reach);

 private:
  void sample(const model::Face& face, const double* nets);
  void add_segment(int from, int to);

  const model::BodyPlan* plan_;
  std::map<int, Eigen::MatrixXd> bases_;  // of each degree, at the lines of cells
  Eigen::MatrixXd blend_;                 // the Gregory function there
  Eigen::MatrixXd y_, z_;                 // of the face in hand
  std::vector<double> half_width_;        // at each height
  double bottom_ = 0.0, step_ = 1.0;
};

}  // namespace bodyline::explore
