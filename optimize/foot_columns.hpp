#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/kernels.hpp"

/// Numbers side by side, as the kernels take them.
namespace bodyline::optimize {

/// Room for `count` numbers in whole groups of the kernels' 8.
constexpr std::size_t padded(int count) { return (std::size_t(count) + 7) / 8 * 8; }

/// Columns of equal lengths, zero at first, with room for whole groups.
class Columns {
 public:
  Columns(int width, int count)
      : length_(padded(count)), numbers_(std::size_t(width) * length_, 0.0) {}

  double* operator[](int column) { return numbers_.data() + std::size_t(column) * length_; }
  Eigen::Vector3d vector(int column, int k) {
    return {(*this)[column][k], (*this)[column + 1][k], (*this)[column + 2][k]};
  }
  void set_vector(int column, int k, const Eigen::Vector3d& value) {
    for (int c = 0; c < 3; ++c) (*this)[column + c][k] = value[c];
  }

 private:
  std::size_t length_;
  std::vector<double> numbers_;
};

/// Points and their feet on a face.
class FootColumns {
 public:
  explicit FootColumns(int count) : count_(count), columns_(width, count) {}

  void set_point(int k, const Eigen::Vector3d& point) { columns_.set_vector(point_at, k, point); }
  double& u(int k) { return columns_[u_at][k]; }
  double& v(int k) { return columns_[v_at][k]; }
  Eigen::Vector3d foot(int k) { return columns_.vector(foot_at, k); }
  /// Along Su x Sv.
  Eigen::Vector3d normal(int k) { return columns_.vector(normal_at, k); }

  /// They point into the columns.
  model::FootPointArrays arrays();

 private:
  enum { point_at = 0, u_at = 3, v_at = 4, foot_at = 5, normal_at = 8, width = 11 };

  int count_;
  Columns columns_;
};

/// Pulls at points of a face, and what their moments do not hold.
class PullColumns {
 public:
  explicit PullColumns(int count) : count_(count), columns_(width, count) {}

  void set(int k, double u, double v, const Eigen::Vector3d& target, const Eigen::Matrix3d& weight);

  model::PullArrays arrays();
  const model::PullSums& sums() const { return sums_; }

 private:
  enum { u_at = 0, v_at = 1, weight_at = 2, target_at = 8, width = 11 };

  int count_;
  Columns columns_;
  model::PullSums sums_;
};

}  // namespace bodyline::optimize
