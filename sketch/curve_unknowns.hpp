#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/connect.hpp"
#include "model/model.hpp"

namespace bodyline::sketch {

/// The independent coordinates of the points of a model's curves. Curves that end in one vertex
/// share its coordinates, and the halves of a central curve mirror each other: whatever the
/// unknowns are, all curves meet exactly.
class CurveUnknowns {
 public:
  explicit CurveUnknowns(const model::Model& model);

  int count() const { return count_; }
  int point_count(int curve) const { return int(follows_[curve].size()) / 3; }

  /// coordinate = factor * unknown + offset; the unknown is -1 where the coordinate is fixed.
  struct Follows {
    int unknown = -1;
    double factor = 1.0, offset = 0.0;
  };
  const Follows& follows(int curve, int point, int axis) const {
    return follows_[curve][3 * point + axis];
  }

  /// The control points of a curve.
  std::vector<Eigen::Vector3d> points(int curve, const Eigen::VectorXd& unknowns) const;

  /// The unknowns that agree with proposed control points as weighted means: `points[c]` are those
  /// of curve c, which count with `weights[c]` > 0.
  Eigen::VectorXd means(const std::vector<std::vector<Eigen::Vector3d>>& points,
                        const std::vector<double>& weights) const;

  /// Puts all control points into a model.
  void write(const Eigen::VectorXd& unknowns, model::Model& model) const;

 private:
  std::vector<std::vector<Follows>> follows_;  // by curve, then point and axis
  int count_ = 0;
};

}  // namespace bodyline::sketch
