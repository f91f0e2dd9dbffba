#include "cli/deviation_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/evaluator.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::cli {
namespace {

constexpr int most_cells = 24, fewest_cells = 4;  // of a face per direction
constexpr double points_per_cell = 3.0;
// What is farther belongs to something else: seats, mirrors, the ground. Far more than a fitted
// body is off, and less than a seat is behind a window.
constexpr double farthest = 100.0;
// An empty cell with so many of its eight neighbours seen is a gap between points, not a hole.
constexpr int filling_neighbours = 4;

using Values = std::vector<double>;

// Points of a face in the middle count on both sides of the plane of symmetry.
std::vector<Values> cells_of(const model::Face& face,
                             const std::vector<const optimize::Match*>& matches, int cells) {
  std::vector<Values> values(std::size_t(cells) * cells);
  const auto add = [&](double u, double v, double distance) {
    const int i = std::clamp(int(u * cells), 0, cells - 1);
    const int j = std::clamp(int(v * cells), 0, cells - 1);
    values[std::size_t(i) * cells + j].push_back(distance);
  };
  for (const optimize::Match* match : matches) {
    add(match->u, match->v, match->distance);
    if (!face.central) continue;
    const bool along_u = face.central_along_u;
    add(along_u ? 1.0 - match->u : match->u, along_u ? match->v : 1.0 - match->v, match->distance);
  }
  return values;
}

void fill_gaps(io::FaceField& field) {
  const io::FaceField seen = field;
  for (int i = 0; i < field.cells; ++i) {
    for (int j = 0; j < field.cells; ++j) {
      if (!std::isnan(seen.at(i, j))) continue;
      double sum = 0.0;
      int count = 0;
      for (int k = 0; k < 9; ++k) {
        const int ni = i + k / 3 - 1, nj = j + k % 3 - 1;
        if (std::min(ni, nj) < 0 || std::max(ni, nj) >= field.cells) continue;
        if (std::isnan(seen.at(ni, nj))) continue;
        sum += seen.at(ni, nj);
        ++count;
      }
      if (count >= filling_neighbours) field.at(i, j) = sum / count;
    }
  }
}

io::FaceField face_field(const model::Face& face,
                         const std::vector<const optimize::Match*>& matches) {
  const double count = double(matches.size()) * (face.central ? 2.0 : 1.0);
  io::FaceField field;
  field.name = face.name;
  field.cells = std::clamp(int(std::sqrt(count / points_per_cell)), fewest_cells, most_cells);
  for (Values& values : cells_of(face, matches, field.cells))
    field.values.push_back(values.empty() ? std::numeric_limits<double>::quiet_NaN()
                                          : optimize::median(std::move(values)));
  fill_gaps(field);
  return field;
}

}  // namespace

io::SurfaceField deviation_field(const model::Model& model, model::Stage stage,
                                 const optimize::Deviation& deviation,
                                 std::optional<double> range) {
  const model::BodyContext context(model);
  const std::vector<model::Face>& faces = context.plan.faces(stage);
  std::vector<std::vector<const optimize::Match*>> of_face(faces.size());
  io::SurfaceField field;
  field.caption = "distance of the scan, mm, positive outside of the body; grey: not seen";
  for (const optimize::Match& match : deviation.matches) {
    if (!(std::abs(match.distance) <= farthest)) continue;
    of_face[std::size_t(match.face)].push_back(&match);
    field.values.push_back(match.distance);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!of_face[f].empty()) field.faces.push_back(face_field(faces[f], of_face[f]));
  }
  field.range = range ? *range : io::symmetric_range(field.values);
  return field;
}

}  // namespace bodyline::cli
