#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace bodyline::model {

/// A picture in square cells, some of them covered, that tells which of the others are open to its
/// border.
class PictureMask {
 public:
  /// A picture of a box with a margin of some cells; `cells` along its longer side. Throws
  /// std::invalid_argument for an empty box.
  PictureMask(const Eigen::AlignedBox2d& box, int cells);

  /// Covers the cells whose middle lies in a triangle, or all cells that a line passes.
  void cover_triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);
  void cover_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

  /// Finds the open cells: those that a path between uncovered cells (side by side) joins to the
  /// border.
  void flood();

  /// Whether a point lies in an open cell or outside of the picture.
  bool open(const Eigen::Vector2d& point) const;

  double cell() const { return cell_; }
  const Eigen::Vector2d& origin() const { return origin_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  enum Cell : std::uint8_t { free, covered, outside };

  Eigen::Vector2d in_cells(const Eigen::Vector2d& point) const { return (point - origin_) / cell_; }
  void cover(int column, int row);

  double cell_ = 1.0;
  Eigen::Vector2d origin_;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> cells_;
};

}  // namespace bodyline::model
