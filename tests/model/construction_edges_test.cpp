// The stages between patches alone: transitions, uncut sides, corners.

#include <gtest/gtest.h>

#include "model/corner_net.hpp"
#include "model/cut.hpp"
#include "model/transition.hpp"
#include "stage_adjoint.hpp"

namespace bodyline::testing {
namespace {

template <class Real>
model::TransitionSide<Real> read_side(Reader<Real>& reader, int n) {
  model::TransitionSide<Real> side;
  reader.points(n + 1, side.edge);
  reader.points(n + 1, side.second);
  side.stretch = reader.number();
  side.fullness = reader.number();
  side.lean[0] = reader.number();
  side.lean[1] = reader.number();
  return side;
}

Numbers<double> side_numbers(int n, std::mt19937& random) {
  Numbers<double> x;
  append_row(x, n + 1, 0.0, 0.0, 1.0, random);
  append_row(x, n + 1, 0.1, -1.0, 1.0, random);
  x.insert(x.end(), {0.4, 1.4, 0.6, 0.3});
  return x;
}

Numbers<double> all_of(const model::TransitionSide<double>& bar, int n) {
  Numbers<double> result;
  append(result, n + 1, bar.edge);
  append(result, n + 1, bar.second);
  result.insert(result.end(), {bar.stretch, bar.fullness, bar.lean[0], bar.lean[1]});
  return result;
}

TEST(ConstructionStages, TransitionIsAdjointToItsPullback) {
  std::mt19937 random(4);
  for (int n = 1; n <= model::max_patch_degree; ++n) {
    for (const bool leaning : {false, true}) {
      const StageFunction stage{[=](const Numbers<Complex>& x) {
                                  Reader<Complex> reader{x};
                                  const auto side = read_side(reader, n);
                                  model::Vec3<Complex> handle[model::max_patch_degree + 1];
                                  model::transition_handle(n, side, leaning, handle);
                                  Numbers<Complex> result;
                                  append(result, n + 1, handle);
                                  return result;
                                },
                                [=](const Numbers<double>& x, const Numbers<double>& w) {
                                  Reader<double> reader{x};
                                  const auto side = read_side(reader, n);
                                  model::Vec3<double> handle_bar[model::max_patch_degree + 1];
                                  Reader<double>{w}.points(n + 1, handle_bar);
                                  model::TransitionSide<double> bar;
                                  model::clear(n, bar);
                                  model::transition_handle_pullback(n, side, leaning, handle_bar,
                                                                    bar);
                                  return all_of(bar, n);
                                }};
      expect_adjoint(stage, side_numbers(n, random), random);
    }
  }
}

// `towards` is how far the free edge leads away from the side: negative where the reach must be
// lifted.
void expect_uncut_adjoint(double towards, std::mt19937& random) {
  for (int n = 1; n <= model::max_patch_degree; ++n) {
    const StageFunction stage{
        [=](const Numbers<Complex>& x) {
          Reader<Complex> reader{x};
          const auto side = read_side(reader, n);
          model::Vec3<Complex> target[2], edge[model::max_patch_degree + 2],
              handle[model::max_patch_degree + 2];
          reader.points(2, target);
          model::UncutTrace<Complex> trace;
          model::uncut_handle(n, side, target, reader.number(), edge, handle, trace);
          Numbers<Complex> result;
          append(result, n + 2, edge);
          append(result, n + 2, handle);
          return result;
        },
        [=](const Numbers<double>& x, const Numbers<double>& w) {
          Reader<double> reader{x}, bars{w};
          const auto side = read_side(reader, n);
          model::Vec3<double> target[2], edge[model::max_patch_degree + 2],
              handle[model::max_patch_degree + 2];
          reader.points(2, target);
          const double width = reader.number();
          model::UncutTrace<double> trace;
          model::uncut_handle(n, side, target, width, edge, handle, trace);
          EXPECT_EQ(trace.solution[0].p < model::least_uncut_reach * side.fullness * width,
                    towards < 0.0);
          model::Vec3<double> target_bar[2] = {};
          bars.points(n + 2, edge);
          bars.points(n + 2, handle);
          model::TransitionSide<double> bar;
          model::clear(n, bar);
          double width_bar = 0.0;
          model::uncut_handle_pullback(n, side, target, width, trace, edge, handle, bar, target_bar,
                                       width_bar);
          Numbers<double> result = all_of(bar, n);
          append(result, 2, target_bar);
          result.push_back(width_bar);
          return result;
        }};
    Numbers<double> x = side_numbers(n, random);
    for (int end = 0; end < 2; ++end) x.insert(x.end(), {0.1, towards, 0.05});
    x.push_back(0.3);
    expect_adjoint(stage, x, random);
  }
}

TEST(ConstructionStages, UncutSideIsAdjointToItsPullback) {
  std::mt19937 random(5);
  expect_uncut_adjoint(0.8, random);
}

TEST(ConstructionStages, LiftedUncutSideIsAdjointToItsPullback) {
  std::mt19937 random(6);
  expect_uncut_adjoint(-0.8, random);
}

// D is the degree of the transitions across their joints.
template <int D>
void expect_corner_adjoint(std::mt19937& random) {
  constexpr int points = model::corner_points(D), each = D + 1;
  for (const model::CornerShape shape : {model::CornerShape{false, true}, {true, false}}) {
    const auto read = [=](auto reader, auto* edges) {
      for (int e = 0; e < 4; ++e) {
        reader.points(each, edges[e].curve);
        reader.points(each, edges[e].inward);
      }
    };
    const StageFunction stage{
        [=](const Numbers<Complex>& x) {
          model::TransitionEnd<Complex, D> edges[4];
          read(Reader<Complex>{x}, edges);
          model::CornerTrace<Complex> trace;
          model::Vec3<Complex> net[points], blend;
          model::corner_net(model::corner_mix<Complex>(shape), edges, trace, net, &blend);
          Numbers<Complex> result;
          append(result, points, net);
          append(result, 1, &blend);
          return result;
        },
        [=](const Numbers<double>& x, const Numbers<double>& w) {
          model::TransitionEnd<double, D> edges[4], bar[4] = {};
          read(Reader<double>{x}, edges);
          model::CornerTrace<double> trace;
          model::Vec3<double> net[points], blend;
          model::corner_net(model::corner_mix<double>(shape), edges, trace, net, &blend);
          Reader<double> bars{w};
          bars.points(points, net);
          model::corner_net_pullback(model::corner_mix<double>(shape), edges, trace, net,
                                     bars.point(), bar);
          Numbers<double> result;
          for (int e = 0; e < 4; ++e) {
            append(result, each, bar[e].curve);
            append(result, each, bar[e].inward);
          }
          return result;
        }};
    // A square's edges with the derivative into it; the top edge of a three-sided corner is fed
    // like any other.
    const double ends[4][2][2] = {
        {{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}, {{1, 0}, {1, 1}}};
    const double inward[4][2] = {{0, 1}, {0, 1}, {1, 0}, {1, 0}};
    Numbers<double> x;
    for (int e = 0; e < 4; ++e) {
      const Numbers<double> noise = random_numbers(random, 6 * each);
      for (int t = 0; t < 2 * each; ++t) {
        for (int c = 0; c < 3; ++c) {
          const double along = double(t) / D;
          const double plain = c == 2     ? 0.0
                               : t < each ? ends[e][0][c] * (1 - along) + ends[e][1][c] * along
                                          : inward[e][c];
          x.push_back(plain + 0.1 * noise[3 * t + c]);
        }
      }
    }
    expect_adjoint(stage, x, random);
  }
}

TEST(ConstructionStages, CornerIsAdjointToItsPullback) {
  std::mt19937 random(8);
  expect_corner_adjoint<3>(random);
}

TEST(ConstructionStages, CornerOfQuinticEdgesIsAdjointToItsPullback) {
  std::mt19937 random(9);
  expect_corner_adjoint<5>(random);
}

}  // namespace
}  // namespace bodyline::testing
