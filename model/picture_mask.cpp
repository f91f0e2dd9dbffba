#include "model/picture_mask.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bodyline::model {
namespace {

using Eigen::Vector2d;

constexpr int margin = 6;  // cells around the box

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

PictureMask::PictureMask(const Eigen::AlignedBox2d& box, int cells) {
  if (box.isEmpty() || !box.sizes().allFinite() || cells < 1)
    throw std::invalid_argument("a picture needs a box and cells");
  cell_ = std::max(box.sizes().maxCoeff() / cells, 1e-9);
  origin_ = box.min() - Vector2d::Constant(margin * cell_);
  width_ = int(std::ceil(box.sizes().x() / cell_)) + 2 * margin;
  height_ = int(std::ceil(box.sizes().y() / cell_)) + 2 * margin;
  cells_.assign(std::size_t(width_) * height_, free);
}

void PictureMask::cover(int column, int row) {
  if (column >= 0 && column < width_ && row >= 0 && row < height_)
    cells_[std::size_t(row) * width_ + column] = covered;
}

void PictureMask::cover_triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d p = in_cells(a), q = in_cells(b), r = in_cells(c);
  const double area = cross(q - p, r - p);
  if (!(std::abs(area) > 0.0)) return;
  const double sign = area > 0.0 ? 1.0 : -1.0;
  const Vector2d low = p.cwiseMin(q).cwiseMin(r), high = p.cwiseMax(q).cwiseMax(r);
  const int first_row = std::max(0, int(std::floor(low.y() - 0.5)));
  const int last_row = std::min(height_ - 1, int(std::ceil(high.y() - 0.5)));
  const int first = std::max(0, int(std::floor(low.x() - 0.5)));
  const int last = std::min(width_ - 1, int(std::ceil(high.x() - 0.5)));
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first; column <= last; ++column) {
      const Vector2d middle(column + 0.5, row + 0.5);
      // Borders count as inside, so that triangles side by side leave nothing between them.
      if (sign * cross(q - p, middle - p) >= 0.0 && sign * cross(r - q, middle - q) >= 0.0 &&
          sign * cross(p - r, middle - r) >= 0.0)
        cover(column, row);
    }
  }
}

void PictureMask::cover_line(const Vector2d& a, const Vector2d& b) {
  const Vector2d from = in_cells(a), along = in_cells(b) - from;
  int column = int(std::floor(from.x())), row = int(std::floor(from.y()));
  const int last_column = int(std::floor(from.x() + along.x()));
  const int last_row = int(std::floor(from.y() + along.y()));
  const int step_x = along.x() < 0.0 ? -1 : 1, step_y = along.y() < 0.0 ? -1 : 1;
  const auto to_border = [](double at, double move, int cell) {
    return move == 0.0 ? HUGE_VAL : ((move > 0.0 ? cell + 1 : cell) - at) / move;
  };
  int left = std::abs(last_column - column) + std::abs(last_row - row);
  cover(column, row);
  // From cell to cell through their sides, so that no path between free cells crosses the line.
  for (; left > 0; --left) {
    if (to_border(from.x(), along.x(), column) < to_border(from.y(), along.y(), row)) {
      column += step_x;
    } else {
      row += step_y;
    }
    cover(column, row);
  }
}

void PictureMask::flood() {
  std::vector<int> stack;
  const auto reach = [&](int column, int row) {
    if (column < 0 || column >= width_ || row < 0 || row >= height_) return;
    const int at = row * width_ + column;
    if (cells_[std::size_t(at)] != free) return;
    cells_[std::size_t(at)] = outside;
    stack.push_back(at);
  };
  for (int column = 0; column < width_; ++column) reach(column, 0), reach(column, height_ - 1);
  for (int row = 0; row < height_; ++row) reach(0, row), reach(width_ - 1, row);
  while (!stack.empty()) {
    const int column = stack.back() % width_, row = stack.back() / width_;
    stack.pop_back();
    reach(column + 1, row), reach(column - 1, row);
    reach(column, row + 1), reach(column, row - 1);
  }
}

bool PictureMask::open(const Vector2d& point) const {
  const Vector2d at = in_cells(point);
  const double column = std::floor(at.x()), row = std::floor(at.y());
  if (!(column >= 0 && column < width_ && row >= 0 && row < height_)) return true;
  return cells_[std::size_t(row) * width_ + std::size_t(column)] == outside;
}

}  // namespace bodyline::model
