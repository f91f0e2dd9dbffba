#include "io/tessellate.hpp"

#include <tbb/parallel_for.h>

#include <stdexcept>

namespace bodyline::io {
namespace {

FaceGrid face_grid(const model::Surface& face, int cells) {
  FaceGrid grid{cells, {}};
  grid.points.reserve((cells + 1) * (cells + 1));
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
      grid.points.push_back(model::jet(face, u, v, 0).d[0]);
    }
  }
  return grid;
}

void check_finite(const model::Surface& face) {
  bool finite = !face.blend || face.blend->allFinite();
  for (const Eigen::Vector3d& point : face.net) finite = finite && point.allFinite();
  if (!finite) {
    throw std::invalid_argument("face " + face.name +
                                " has a control point that is not a finite number");
  }
}

}  // namespace

std::vector<FaceGrid> tessellate(const std::vector<model::Surface>& faces, int cells) {
  for (const model::Surface& face : faces) check_finite(face);
  std::vector<FaceGrid> grids(faces.size());
  tbb::parallel_for(std::size_t{0}, faces.size(),
                    [&](std::size_t f) { grids[f] = face_grid(faces[f], cells); });
  return grids;
}

}  // namespace bodyline::io
