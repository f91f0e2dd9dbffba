#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "model/picture_mask.hpp"

namespace bodyline::model {

/// Tells which points of lines in a picture border what is open around the picture. The mask says
/// where that is, up to its cells; lines between a point and the open decide what is nearer.
class OuterTest {
 public:
  /// `mask` is flooded. `lines` are the lines that may hide points, as many as there are.
  OuterTest(PictureMask mask, std::vector<std::vector<Eigen::Vector2d>> lines);

  /// A point on a line, between its points `first` and `last`, which are neighbours or the same.
  struct Place {
    int line = -1;
    int first = 0, last = 0;
  };

  /// Whether the open is next to a place on the side of the line to which a unit vector points.
  bool opens(const Eigen::Vector2d& point, const Eigen::Vector2d& side, const Place& place) const;

  /// The unit vector, `normal` or its opposite, that points from a place into the open; none when
  /// the place is hidden. `normal` is square to the line.
  std::optional<Eigen::Vector2d> outwards(const Eigen::Vector2d& point,
                                          const Eigen::Vector2d& normal, const Place& place) const;

  /// Whether no line is met on the way straight from a place, `length` long.
  bool clear(const Eigen::Vector2d& point, const Eigen::Vector2d& direction, double length,
             const Place& place) const;

 private:
  struct Segment {
    Eigen::Vector2d a, b;
    int line, index;  // from the line's point of this index to the next
  };
  bool leads_out(const Eigen::Vector2d& point, const Eigen::Vector2d& direction,
                 const Place& place) const;
  bool crossed(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Place& place) const;
  Eigen::Array2i bin_of(const Eigen::Vector2d& point) const;

  PictureMask mask_;
  std::vector<Segment> segments_;
  double bin_ = 1.0;  // side of the squares that list what passes them
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<int>> bins_;
};

}  // namespace bodyline::model
