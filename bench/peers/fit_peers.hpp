#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "bench/peers/peers.hpp"

namespace bodyline::bench {

/// Points matched with one face: minimise the sum of (normal . (S(u, v) - target))^2 over its net.
struct FitFace {
  int degree_u = 0, degree_v = 0;
  std::vector<double> net;  ///< xyz fastest, then v
  std::vector<Eigen::Vector2d> parameters;
  std::vector<Eigen::Vector3d> normals, targets;
};

/// The same squares as |root * net - target|^2.
struct FitSquares {
  Eigen::MatrixXd root;
  Eigen::VectorXd target;
};

/// One step of Ceres's Levenberg-Marquardt for the nets of all faces, on two threads, from the same
/// start at every call.
class BODYLINE_PEER CeresFit {
 public:
  enum class Blocks { one_a_face, one_a_point };
  CeresFit(std::vector<FitFace> faces, Blocks blocks);
  explicit CeresFit(const std::vector<FitSquares>& squares, std::vector<FitFace> faces);
  ~CeresFit();
  double step();  ///< the cost after it

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Points on or near one patch, each with parameters close to those of its nearest point.
class BODYLINE_PEER OcctNearest {
 public:
  explicit OcctNearest(const FitFace& face);
  ~OcctNearest();
  /// Extrema_GenLocateExtPS from the given parameters, point by point; the sum of squared
  /// distances.
  double nearest(std::size_t first, std::size_t count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The nearest of many samples, found by nanoflann in three dimensions.
class BODYLINE_PEER NanoflannNearest {
 public:
  explicit NanoflannNearest(std::vector<Eigen::Vector3d> samples);
  ~NanoflannNearest();
  double nearest(const std::vector<Eigen::Vector3d>& points, std::size_t first,
                 std::size_t count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The nearest point of a tessellation, found by Embree's point query.
class BODYLINE_PEER EmbreeNearest {
 public:
  EmbreeNearest(const std::vector<Eigen::Vector3d>& vertices,
                const std::vector<std::array<int, 3>>& triangles);
  ~EmbreeNearest();
  double nearest(const std::vector<Eigen::Vector3d>& points, std::size_t first,
                 std::size_t count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bodyline::bench
