#pragma once

#include <vector>

#include "model/random.hpp"
#include "model/surface.hpp"

namespace bodyline::optimize {

/// A place on a face.
struct FacePoint {
  int face = 0;
  double u = 0.0, v = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mm
};

/// Random points on faces, uniform by area: a cell of a grid over the parameters is chosen by a
/// bound of its area, and a point in it is taken with probability area element / bound.
class BodySampler {
 public:
  /// Throws std::invalid_argument when the faces have no area.
  explicit BodySampler(std::vector<model::Surface> faces);

  FacePoint next(model::Random& random) const;

  const std::vector<model::Surface>& faces() const { return faces_; }

 private:
  struct Cell {
    int face = 0;
    double u = 0.0, v = 0.0;      ///< its lower corner
    double bound = 0.0;           ///< of the area element, mm2
    double bounds_to_here = 0.0;  ///< sum over this cell and all before
  };

  void add_cells(int face);

  std::vector<model::Surface> faces_;
  std::vector<Cell> cells_;
};

}  // namespace bodyline::optimize
