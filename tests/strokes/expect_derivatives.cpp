#include "tests/strokes/expect_derivatives.hpp"

#include <gtest/gtest.h>

namespace bodyline::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double step = 1e-4;
// Central differences of waves of a few hundred mm, and their rounding over step^2.
constexpr double difference_error = 1e-4;

}  // namespace

void expect_derivatives(const strokes::SurfaceFunction& surface, const Vector2d& place) {
  const auto at = [&](double s, double t) { return surface(place + step * Vector2d(s, t)).point; };
  const strokes::PatchJet jet = surface(place);
  const auto expect = [](const Vector3d& difference, const Vector3d& derivative) {
    EXPECT_LE((difference - derivative).norm(), difference_error * (1.0 + derivative.norm()));
  };
  expect((at(1, 0) - at(-1, 0)) / (2 * step), jet.s);
  expect((at(0, 1) - at(0, -1)) / (2 * step), jet.t);
  const auto first = [&](double s, double t) { return surface(place + step * Vector2d(s, t)); };
  expect((first(1, 0).s - first(-1, 0).s) / (2 * step), jet.ss);
  expect((first(0, 1).s - first(0, -1).s) / (2 * step), jet.st);
  expect((first(1, 0).t - first(-1, 0).t) / (2 * step), jet.st);
  expect((first(0, 1).t - first(0, -1).t) / (2 * step), jet.tt);
  EXPECT_GT(jet.ss.norm() + jet.st.norm() + jet.tt.norm(), 1.0);
}

}  // namespace bodyline::test
