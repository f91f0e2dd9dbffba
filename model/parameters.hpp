#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/model.hpp"

/// All numbers of a model in one flat vector, before any ties. Variables (variables.hpp) are what
/// may change freely.
namespace bodyline::model {

enum class ParameterKind { curve, shape, cut, fullness, lean };

/// Where each number of a model lies in the flat vector.
class ParameterLayout {
 public:
  explicit ParameterLayout(const Model& model);

  int size() const { return size_; }
  /// First of the three coordinates of a curve's point.
  int point(int curve, int index) const { return curves_[curve] + 3 * index; }
  int shape_u(int patch, int index) const { return shapes_[patch] + index; }
  int shape_v(int patch, int index) const {
    return shapes_[patch] + shape_u_counts_[patch] + index;
  }
  /// u_lo, u_hi, v_lo, v_hi are consecutive.
  int cut(int patch) const { return cuts_ + 4 * patch; }
  int fullness(int joint, int side) const { return fullness_ + 2 * joint + side; }
  int lean(int joint, int side, int end) const { return leans_ + 4 * joint + 2 * side + end; }

  ParameterKind kind(int parameter) const;

 private:
  std::vector<int> curves_, shapes_, shape_u_counts_;
  int first_shape_ = 0, cuts_ = 0, fullness_ = 0, leans_ = 0, size_ = 0;
};

/// Names of all parameters: curve.NAME[k].x, shape.PATCH.u[k], cut.PATCH.u_lo, fullness.JOINT.a,
/// lean.JOINT.b[end].
std::vector<std::string> parameter_names(const Model& model, const ParameterLayout& layout);

/// The model's numbers, layout.size() of them.
Eigen::VectorXd to_parameters(const Model& model, const ParameterLayout& layout);

/// Writes numbers back into a model of the same layout.
void set_parameters(Model& model, const ParameterLayout& layout, const Eigen::VectorXd& parameters);

}  // namespace bodyline::model
