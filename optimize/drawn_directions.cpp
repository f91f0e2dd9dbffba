#include "optimize/drawn_directions.hpp"

#include "optimize/outline_deviation.hpp"

namespace bodyline::optimize {
namespace {

// Measured on outlines of seven cars against three others: those that point as said reach 0.94 and
// more from the side, 0.79 and more from the top; of those that do not, 18 of 21 are found from the
// side and 5 of 21 from the top.
constexpr double clearly_nearer = 0.7;

bool tells(model::View view) { return view == model::View::side || view == model::View::top; }

model::PlacedDrawing turned(model::PlacedDrawing drawing) {
  const Eigen::AlignedBox2d box = model::drawn_box(drawing.paths);
  const double sum = box.min().x() + box.max().x();
  for (model::DrawnPath& path : drawing.paths) {
    for (model::CubicSegment& segment : path.segments) {
      for (Eigen::Vector2d& point : segment.points) point.x() = sum - point.x();
    }
  }
  return drawing;
}

}  // namespace

DrawnDirections drawn_directions(const model::Model& body,
                                 const std::vector<model::PlacedDrawing>& drawings) {
  DrawnDirections result;
  for (const model::PlacedDrawing& drawing : drawings) {
    if (!tells(drawing.view)) continue;
    const auto both = measure_outlines(body, {drawing, turned(drawing)});
    const bool reversed = both[1].median < clearly_nearer * both[0].median;
    (reversed ? result.reversed : result.as_said).push_back(drawing.view);
  }
  return result;
}

}  // namespace bodyline::optimize
