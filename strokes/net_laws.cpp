#include "strokes/net_laws.hpp"

#include <algorithm>
#include <cmath>

#include "strokes/points.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;

constexpr double area_resolution = 1e-9;

std::string numbered(const char* what, std::size_t number, const char* says) {
  return std::string(what) + " " + std::to_string(number) + " " + says;
}

bool has(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

void look_at_edges(const Net& net, std::vector<std::string>& broken) {
  for (std::size_t k = 0; k < net.edges.size(); ++k) {
    const Edge& edge = net.edges[k];
    if (edge.left < 0 && edge.right < 0) broken.push_back(numbered("edge", k, "has no patch"));
    for (const int end : {edge.start, edge.end}) {
      if (!has(net.vertices[end].edges, static_cast<int>(k)))
        broken.push_back(numbered("edge", k, "is not known to its vertex"));
    }
    if (edge.curve.points.front() != net.vertices[edge.start].point ||
        edge.curve.points.back() != net.vertices[edge.end].point)
      broken.push_back(numbered("edge", k, "does not end at its vertices"));
  }
}

// Whether a side goes straight, and from the end of one edge to the begin of the next.
bool is_straight_chain(const Net& net, const std::vector<EdgeUse>& side) {
  const Vector2d from = net.vertices[first_vertex(net, side.front())].place;
  const Vector2d to = net.vertices[last_vertex(net, side.back())].place;
  for (std::size_t k = 1; k < side.size(); ++k) {
    const int vertex = first_vertex(net, side[k]);
    if (vertex != last_vertex(net, side[k - 1])) return false;
    const Vector2d place = net.vertices[vertex].place;
    if (std::abs(cross(to - from, place - from)) > same_place * (to - from).norm()) return false;
  }
  return true;
}

void look_at_patches(const Net& net, std::vector<std::string>& broken) {
  std::vector<int> uses(net.edges.size(), 0);
  for (std::size_t k = 0; k < net.patches.size(); ++k) {
    const Patch& patch = net.patches[k];
    const std::size_t sides = patch.sides.size();
    if (sides != 3 && sides != 4)
      broken.push_back(numbered("patch", k, "has a wrong number of sides"));
    if (!is_convex(polygon(net, patch)) || area(polygon(net, patch)) <= 0.0)
      broken.push_back(numbered("patch", k, "is not convex"));
    for (std::size_t s = 0; s < sides; ++s) {
      const auto& side = patch.sides[s];
      if (!is_straight_chain(net, side)) broken.push_back(numbered("patch", k, "has a bent side"));
      if (last_vertex(net, side.back()) != first_vertex(net, patch.sides[(s + 1) % sides]))
        broken.push_back(numbered("patch", k, "does not close"));
      for (const EdgeUse& use : side) {
        ++uses[use.edge];
        const Edge& edge = net.edges[use.edge];
        if ((use.reversed ? edge.right : edge.left) != static_cast<int>(k))
          broken.push_back(numbered("patch", k, "is not known to its edge"));
      }
    }
  }
  for (std::size_t k = 0; k < uses.size(); ++k)
    if (uses[k] != (is_outer(net.edges[k]) ? 1 : 2))
      broken.push_back(numbered("edge", k, "has a wrong number of patches"));
}

double side_length(const Net& net, const std::vector<EdgeUse>& side) {
  double length = 0.0;
  for (const EdgeUse& use : side) length += domain_length(net, net.edges[use.edge]);
  return length;
}

// Where a patch is `along` of the way along a side, counter-clockwise.
Vector2d side_parameters(const Patch& patch, std::size_t side, double along) {
  if (side == 0) return {along, 0.0};
  if (side == 1) return {1.0, along};
  if (side == 2 && patch.sides.size() == 4) return {1.0 - along, 1.0};
  return {0.0, 1.0 - along};
}

}  // namespace

double largest_gap(const Net& net, int samples) {
  double largest = 0.0;
  for (const Patch& patch : net.patches) {
    for (std::size_t side = 0; side < patch.sides.size(); ++side) {
      double along = 0.0;
      const double whole = side_length(net, patch.sides[side]);
      for (const EdgeUse& use : patch.sides[side]) {
        const Edge& edge = net.edges[use.edge];
        const double part = domain_length(net, edge) / whole;
        for (int k = 0; k < samples; ++k) {
          const double t = static_cast<double>(k) / (samples - 1);
          const Eigen::Vector3d there =
              patch.shape->point(side_parameters(patch, side, std::min(1.0, along + t * part)));
          const Eigen::Vector3d point = model::curve_point(edge.curve, use.reversed ? 1.0 - t : t);
          largest = larger((there - point).norm(), largest);
        }
        along += part;
      }
    }
  }
  return largest;
}

std::vector<std::string> broken_laws(const Net& net, double whole_area, double gap_mm) {
  std::vector<std::string> broken;
  if (!(std::abs(domain_area(net) - whole_area) <= area_resolution))
    broken.emplace_back("the areas of the patches do not sum to that of the domain");
  const auto euler = static_cast<std::ptrdiff_t>(net.vertices.size() + net.patches.size()) -
                     static_cast<std::ptrdiff_t>(net.edges.size());
  if (euler != 1) broken.push_back("V - E + F is " + std::to_string(euler) + ", not 1");
  look_at_edges(net, broken);
  look_at_patches(net, broken);
  const double gap = largest_gap(net);
  if (!(gap <= gap_mm))
    broken.push_back("patches miss their edges by " + std::to_string(gap) + " mm");
  return broken;
}

}  // namespace bodyline::strokes
