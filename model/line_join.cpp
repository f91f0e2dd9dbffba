#include "model/line_join.hpp"

namespace bodyline::model {

using Eigen::Vector3d;

LineJoin first_order(LineJoin join) {
  join.first.a = join.first.b = join.second.a = join.slide = 0.0;
  join.second.b = 1.0;
  return join;
}

LineEnd joined_line(const LineJoin& join, const LineEnd& first) {
  const Vector3d across = first[0] - first[1];
  const Vector3d first2 = join.first.a * across + join.first.b * (first[2] - first[1]);
  const Vector3d step = (join.ratio * join.first.d / join.second.d) * across;
  const Vector3d second2 = join.ratio * join.ratio * first2 + join.slide * join.first.d * across;
  LineEnd second;
  second[0] = first[0];
  second[1] = first[0] + step;
  second[2] = second[1] + (join.second.a * step + second2) / join.second.b;
  return second;
}

void joined_line_pullback(const LineJoin& join, const LineEnd& first, const LineEnd& second_bar,
                          LineEnd& first_bar, LineJoin& join_bar) {
  const EndConstants &c1 = join.first, &c2 = join.second;
  const double ratio = join.ratio, stretch = ratio * c1.d / c2.d;
  const Vector3d across = first[0] - first[1], inner = first[2] - first[1];
  const Vector3d first2 = c1.a * across + c1.b * inner;
  const Vector3d step = stretch * across;
  const Vector3d second2 = ratio * ratio * first2 + join.slide * c1.d * across;

  const Vector3d second1_bar = second_bar[1] + second_bar[2];
  const Vector3d bend_bar = second_bar[2] / c2.b;
  join_bar.second.b -= bend_bar.dot(c2.a * step + second2) / c2.b;
  join_bar.second.a += bend_bar.dot(step);
  const Vector3d step_bar = second1_bar + c2.a * bend_bar;
  const Vector3d first2_bar = ratio * ratio * bend_bar;
  const double along = bend_bar.dot(across), stretch_bar = step_bar.dot(across);
  join_bar.slide += c1.d * along;
  join_bar.ratio += 2.0 * ratio * bend_bar.dot(first2) + stretch_bar * c1.d / c2.d;
  join_bar.first.d += join.slide * along + stretch_bar * ratio / c2.d;
  join_bar.second.d -= stretch_bar * stretch / c2.d;
  join_bar.first.a += first2_bar.dot(across);
  join_bar.first.b += first2_bar.dot(inner);
  const Vector3d across_bar = stretch * step_bar + c1.a * first2_bar + join.slide * c1.d * bend_bar;
  const Vector3d inner_bar = c1.b * first2_bar;
  first_bar[0] += second_bar[0] + second1_bar + across_bar;
  first_bar[1] -= across_bar + inner_bar;
  first_bar[2] += inner_bar;
}

}  // namespace bodyline::model
