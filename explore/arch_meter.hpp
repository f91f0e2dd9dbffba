#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/measures_wheelbase.hpp"
#include "model/model.hpp"
#include "model/parameters.hpp"

namespace bodyline::explore {

/// Finds the circle of one wheel arch as model/measures_wheelbase.hpp does, from a parameter vector
/// and without allocating.
class ArchMeter {
 public:
  ArchMeter(const model::Model& model, const model::ParameterLayout& layout,
            const model::WheelArch& arch);

  /// Whether any of these parameters moves the arch.
  bool moves_with(const std::vector<int>& parameters) const;

  /// NaN where the curves determine no circle.
  model::ArchCircle measure(const Eigen::VectorXd& parameters);

 private:
  struct ArchCurve {
    std::vector<int> points;    // parameter of the x of each
    Eigen::MatrixXd at, along;  // from points to positions, and to lengths of pieces
  };
  void sample(const Eigen::VectorXd& parameters);
  model::ArchCircle first_circle();
  double improve(model::ArchCircle& circle);

  std::vector<ArchCurve> curves_;
  Eigen::ArrayXd x_, z_, weight_;                            // of the midpoints of all pieces
  Eigen::ArrayXd dx_, dz_, reciprocal_, scaled_, weighted_;  // room to work in
};

}  // namespace bodyline::explore
