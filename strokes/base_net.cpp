#include "strokes/base_net.hpp"

#include <cmath>

#include "strokes/coons_shape.hpp"

namespace bodyline::strokes {

Polygon base_domain(std::size_t sides) {
  if (sides == 3) return {{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.5 * std::sqrt(3.0)}};
  return {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
}

Net base_net(std::vector<Points> loop) {
  if (loop.size() == 4) {
    equalise(loop[0], loop[2]);
    equalise(loop[1], loop[3]);
  }
  std::vector<model::SplineCurve> curves;
  for (Points& side : loop)
    curves.push_back(model::polyline_curve(index_parameters(side.size()), side));
  return base_net(curves);
}

Net base_net(const std::vector<model::SplineCurve>& loop) {
  const int sides = static_cast<int>(loop.size());
  const Polygon domain = base_domain(loop.size());
  Net net;
  Patch patch;
  for (int k = 0; k < sides; ++k) {
    net.vertices.push_back({domain[k], loop[k].points.front(), {(k + sides - 1) % sides, k}});
    net.edges.push_back({k, (k + 1) % sides, loop[k], 0, -1, -1});
    patch.sides.push_back({{k, false}});
  }
  net.patches.push_back(std::move(patch));
  turn_to_apex(net, net.patches.front());
  net.patches.front().shape = coons_shape(net, net.patches.front());
  return net;
}

}  // namespace bodyline::strokes
