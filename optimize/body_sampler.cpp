#include "optimize/body_sampler.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace bodyline::optimize {
namespace {

constexpr int cells = 16;        // of a face, per direction
constexpr double margin = 1.05;  // the largest element within a cell over that at its 3 x 3 points

double area_element(const model::SurfaceJet& jet) {
  return jet.d[model::jet_index(1, 0)].cross(jet.d[model::jet_index(0, 1)]).norm();
}

// Elements at the corners and the middles of all cells, v fastest.
std::vector<double> area_elements(const model::Surface& face) {
  constexpr int last = 2 * cells;
  std::vector<double> elements;
  for (int i = 0; i <= last; ++i) {
    for (int j = 0; j <= last; ++j) {
      elements.push_back(area_element(model::jet(face, i / double(last), j / double(last), 1)));
    }
  }
  return elements;
}

}  // namespace

BodySampler::BodySampler(std::vector<model::Surface> faces) : faces_(std::move(faces)) {
  for (int face = 0; face < int(faces_.size()); ++face) add_cells(face);
  if (cells_.empty()) throw std::invalid_argument("the body has no area to put points on");
}

void BodySampler::add_cells(int face) {
  const std::vector<double> elements = area_elements(faces_[face]);
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      double largest = 0.0;
      for (int k = 0; k < 9; ++k) {
        const int row = 2 * i + k / 3, column = 2 * j + k % 3;
        largest = std::max(largest, elements[row * (2 * cells + 1) + column]);
      }
      if (!(largest > 0.0)) continue;
      const double before = cells_.empty() ? 0.0 : cells_.back().bounds_to_here;
      const double bound = margin * largest;
      cells_.push_back({face, i / double(cells), j / double(cells), bound, before + bound});
    }
  }
}

FacePoint BodySampler::next(model::Random& random) const {
  while (true) {
    const double chosen = random.uniform() * cells_.back().bounds_to_here;
    const auto cell = std::upper_bound(
        cells_.begin(), cells_.end() - 1, chosen,
        [](double value, const Cell& candidate) { return value < candidate.bounds_to_here; });
    FacePoint point;
    point.face = cell->face;
    point.u = cell->u + random.uniform() / cells;
    point.v = cell->v + random.uniform() / cells;
    const model::SurfaceJet jet = model::jet(faces_[point.face], point.u, point.v, 1);
    point.position = jet.d[0];
    if (random.uniform() * cell->bound < area_element(jet)) return point;
  }
}

}  // namespace bodyline::optimize
