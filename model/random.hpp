#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace bodyline::model {

/// Random numbers with the same bits for the same seed on every machine: the engine is fixed by the
/// C++ standard, and what is made of it needs only sums, products and comparisons (square roots for
/// directions). The distributions of the standard library differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1), a multiple of 2^-53.
  double uniform();

  /// 0 to count - 1, count at least 1.
  std::uint64_t below(std::uint64_t count);

  /// Mean 0, variance 1.
  double normal();

  /// Unit vector, uniform on the sphere.
  Eigen::Vector3d direction();

 private:
  bool chance_of_decay(double exponent);

  std::mt19937_64 engine_;
};

}  // namespace bodyline::model
