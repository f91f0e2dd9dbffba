#include "strokes/boundary_loop.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "model/name_matches.hpp"
#include "strokes/close_loop.hpp"
#include "strokes/find_boundary.hpp"
#include "strokes/merge_sides.hpp"
#include "strokes/order_loop.hpp"

namespace bodyline::strokes {
namespace {

bool begins_with_boundary(const std::string& name) {
  const std::string word = "boundary";
  return name.size() >= word.size() &&
         std::equal(word.begin(), word.end(), name.begin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

std::vector<int> matching(const std::vector<model::Stroke>& strokes, const std::string& pattern) {
  std::vector<int> indices;
  for (std::size_t k = 0; k < strokes.size(); ++k)
    if (model::name_matches(pattern, strokes[k].name)) indices.push_back(static_cast<int>(k));
  return indices;
}

std::vector<int> named(const std::vector<model::Stroke>& strokes,
                       const std::vector<std::string>& patterns) {
  std::vector<int> members;
  for (const std::string& pattern : patterns) {
    const std::vector<int> found = matching(strokes, pattern);
    if (found.empty()) throw std::invalid_argument("no stroke is called '" + pattern + "'");
    members.insert(members.end(), found.begin(), found.end());
  }
  for (std::size_t k = 0; patterns.empty() && k < strokes.size(); ++k)
    if (begins_with_boundary(strokes[k].name)) members.push_back(static_cast<int>(k));
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  return members;
}

// Strokes that can be used at all, and which they are.
std::vector<int> found(const std::vector<model::Stroke>& strokes, double threshold) {
  std::vector<Points> usable;
  std::vector<int> index;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    if (!all_finite(strokes[k].points)) continue;
    Points points = filtered(strokes[k].points, threshold);
    if (points.size() < 2) continue;
    usable.push_back(std::move(points));
    index.push_back(static_cast<int>(k));
  }
  const auto loop = find_boundary(usable, threshold);
  if (!loop)
    throw std::invalid_argument(
        "three or more strokes that close a boundary around the others are not found; name them");
  std::vector<int> members;
  for (const int k : *loop) members.push_back(index[k]);
  std::sort(members.begin(), members.end());
  return members;
}

Points boundary_points(const model::Stroke& stroke, double threshold) {
  if (!all_finite(stroke.points))
    throw std::invalid_argument("stroke '" + stroke.name + "' of the boundary has a coordinate " +
                                "that is not a finite number");
  Points points = filtered(stroke.points, threshold);
  if (points.size() < 2 || polyline_length(points) == 0.0)
    throw std::invalid_argument("stroke '" + stroke.name + "' of the boundary is a point");
  return points;
}

void turn_upwards(std::vector<Points>& loop, std::vector<std::string>& names) {
  Points polygon;
  for (const Points& side : loop) polygon.insert(polygon.end(), side.begin(), side.end());
  const Eigen::Vector3d area = vector_area(polygon);
  Eigen::Index largest = 0;
  area.cwiseAbs().maxCoeff(&largest);
  if (area[largest] >= 0.0) return;
  for (Points& side : loop) std::reverse(side.begin(), side.end());
  std::reverse(loop.begin() + 1, loop.end());
  std::reverse(names.begin() + 1, names.end());
}

}  // namespace

BoundaryLoop boundary_loop(const std::vector<model::Stroke>& strokes,
                           const std::vector<std::string>& patterns, double threshold) {
  BoundaryLoop result;
  result.members = named(strokes, patterns);
  result.report.found = result.members.empty();
  if (result.report.found) result.members = found(strokes, threshold);
  if (result.members.size() < 3)
    throw std::invalid_argument("a boundary takes three strokes or more, not " +
                                std::to_string(result.members.size()));
  std::vector<Points> drawn;
  for (const int k : result.members) drawn.push_back(boundary_points(strokes[k], threshold));
  const std::vector<LoopMember> order = order_loop(drawn);
  for (const LoopMember& member : order)
    result.report.strokes.push_back(strokes[result.members[member.index]].name);
  result.sides = ordered(drawn, order);
  turn_upwards(result.sides, result.report.strokes);
  const LoopClosure closure = close_loop(result.sides, threshold);
  merge_sides(result.sides);
  result.report.largest_gap_mm = closure.largest_gap;
  result.report.crossings = closure.crossings;
  result.report.sides = static_cast<int>(result.sides.size());
  return result;
}

}  // namespace bodyline::strokes
