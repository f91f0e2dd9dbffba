// Every stage alone: <J v, w> = <v, J^T w>, with J v by the complex step and J^T w by the pullback.

#include <gtest/gtest.h>

#include <complex>
#include <functional>
#include <random>
#include <vector>

#include "construction_models.hpp"
#include "model/corner_net.hpp"
#include "model/cut.hpp"
#include "model/seam.hpp"
#include "model/sq_coons.hpp"
#include "model/transition.hpp"

namespace bodyline::testing {
namespace {

using Complex = std::complex<double>;
template <class Real>
using Numbers = std::vector<Real>;

// Both products are sums of some hundred rounded numbers.
constexpr double adjoint_tolerance = 1e-13;
constexpr double complex_step = 1e-100;

// A stage as a function of numbers: forward for any type, and the pullback.
struct StageFunction {
  std::function<Numbers<Complex>(const Numbers<Complex>&)> forward;
  std::function<Numbers<double>(const Numbers<double>& x, const Numbers<double>& bar)> pullback;
};

void expect_adjoint(const StageFunction& stage, const Numbers<double>& x, std::mt19937& random) {
  const Numbers<double> v = random_numbers(random, int(x.size()));
  Numbers<Complex> moved(x.begin(), x.end());
  for (std::size_t k = 0; k < x.size(); ++k) moved[k] += Complex(0.0, complex_step * v[k]);
  const Numbers<Complex> result = stage.forward(moved);
  const Numbers<double> w = random_numbers(random, int(result.size()));
  const Numbers<double> pulled = stage.pullback(x, w);
  double forward = 0.0, backward = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double term = result[k].imag() / complex_step * w[k];
    forward += term;
    scale += std::abs(term);
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    backward += v[k] * pulled[k];
    scale += std::abs(v[k] * pulled[k]);
  }
  EXPECT_NEAR(forward, backward, adjoint_tolerance * scale);
  EXPECT_GT(std::abs(forward), 0.0);
}

// Reads points and numbers one after the other, and appends them likewise.
template <class Real>
struct Reader {
  const Numbers<Real>& from;
  std::size_t next = 0;
  Real number() { return from[next++]; }
  model::Vec3<Real> point() {
    const Real x = number(), y = number(), z = number();
    return {x, y, z};
  }
  void points(int count, model::Vec3<Real>* to) {
    for (int k = 0; k < count; ++k) to[k] = point();
  }
};
template <class Real>
void append(Numbers<Real>& to, int count, const model::Vec3<Real>* points) {
  for (int k = 0; k < count; ++k) to.insert(to.end(), {points[k].x, points[k].y, points[k].z});
}

// Numbers at which a stage is regular: points of a grid that goes on along x, y by `step`, moved at
// random.
void append_row(Numbers<double>& to, int count, double x0, double y0, double step,
                std::mt19937& random) {
  const Numbers<double> noise = random_numbers(random, 3 * count);
  for (int k = 0; k < count; ++k) {
    to.insert(to.end(), {x0 + step * k + 0.1 * noise[3 * k], y0 + 0.1 * noise[3 * k + 1],
                         0.2 * noise[3 * k + 2]});
  }
}

TEST(ConstructionStages, BaseNetIsAdjointToItsPullback) {
  std::mt19937 random(1);
  for (int m = 2; m <= model::max_patch_degree; ++m) {
    for (const int n : {1, 2, 3, 4, 5, 9}) {
      const int points = (m + 1) * (n + 1);
      const auto interior = [m, n](int k) {
        const int i = k / (n + 1), j = k % (n + 1);
        return i > 0 && i < m && j > 0 && j < n;
      };
      const StageFunction stage{
          [=](const Numbers<Complex>& x) {
            Numbers<model::Vec3<Complex>> net(points);
            Reader<Complex> reader{x};
            reader.points(points, net.data());
            model::sq_coons(m, n, net.data(), &x[3 * points], &x[3 * points] + m - 1);
            Numbers<Complex> result;
            append(result, points, net.data());
            return result;
          },
          [=](const Numbers<double>& x, const Numbers<double>& bar) {
            Numbers<model::Vec3<double>> net(points), net_bar(points);
            Reader<double>{x}.points(points, net.data());
            Reader<double>{bar}.points(points, net_bar.data());
            Numbers<double> shape_bar(m + n);
            model::sq_coons_pullback(m, n, net.data(), &x[3 * points], &x[3 * points] + m - 1,
                                     net_bar.data(), shape_bar.data(), shape_bar.data() + m - 1);
            for (int k = 0; k < points; ++k) {
              if (interior(k)) net_bar[k] = model::Vec3<double>{};
            }
            Numbers<double> result;
            append(result, points, net_bar.data());
            result.insert(result.end(), shape_bar.begin(), shape_bar.end());
            return result;
          }};
      expect_adjoint(stage, random_numbers(random, 3 * points + m + n), random);
    }
  }
}

TEST(ConstructionStages, KeptNetIsAdjointToItsPullback) {
  std::mt19937 random(2);
  for (int m = 1; m <= model::max_patch_degree; m += 2) {
    for (const int n : {1, 2, 3, 5, 9}) {
      const int points = (m + 1) * (n + 1);
      const auto matrices = [=](auto* limits, auto* in_u, auto* in_v) {
        model::cut_matrix(m, limits[0], limits[1], in_u);
        model::cut_matrix(n, limits[2], limits[3], in_v);
      };
      const StageFunction stage{
          [=](const Numbers<Complex>& x) {
            Numbers<model::Vec3<Complex>> net(points), kept(points);
            Reader<Complex>{x}.points(points, net.data());
            Complex in_u[100], in_v[100];
            matrices(&x[3 * points], in_u, in_v);
            model::cut(m, n, in_u, in_v, net.data(), kept.data());
            Numbers<Complex> result;
            append(result, points, kept.data());
            return result;
          },
          [=](const Numbers<double>& x, const Numbers<double>& bar) {
            Numbers<model::Vec3<double>> net(points), kept(points), kept_bar(points),
                net_bar(points);
            Reader<double>{x}.points(points, net.data());
            Reader<double>{bar}.points(points, kept_bar.data());
            std::fill(net_bar.begin(), net_bar.end(), model::Vec3<double>{});
            double in_u[100], in_v[100];
            const double* limits = &x[3 * points];
            matrices(limits, in_u, in_v);
            model::cut(m, n, in_u, in_v, net.data(), kept.data());
            model::cut_pullback(m, n, in_u, in_v, kept_bar.data(), net_bar.data());
            const model::CutBar<double> cut_bar = model::cut_range_pullback(
                m, n, limits[1] - limits[0], limits[3] - limits[2], kept.data(), kept_bar.data());
            Numbers<double> result;
            append(result, points, net_bar.data());
            result.insert(result.end(), {cut_bar.u_lo, cut_bar.u_hi, cut_bar.v_lo, cut_bar.v_hi});
            return result;
          }};
      Numbers<double> x = random_numbers(random, 3 * points);
      x.insert(x.end(), {0.1, 0.85, 0.23, 0.97});
      expect_adjoint(stage, x, random);
    }
  }
}

TEST(ConstructionStages, SeamIsAdjointToItsPullback) {
  std::mt19937 random(3);
  for (int n = 2; n <= model::max_patch_degree; ++n) {
    const int count = n + 1;
    const auto read = [=](auto reader, auto& rows) {
      reader.points(count, rows.edge);
      reader.points(count, rows.across_a);
      reader.points(count, rows.across_b);
    };
    const auto all = [=](const auto& rows) {
      Numbers<std::remove_cvref_t<decltype(rows.edge[0].x)>> result;
      append(result, count, rows.edge);
      append(result, count, rows.across_a);
      append(result, count, rows.across_b);
      return result;
    };
    const StageFunction stage{[=](const Numbers<Complex>& x) {
                                model::SeamRows<Complex> rows;
                                model::SeamTrace<Complex> trace;
                                read(Reader<Complex>{x}, rows);
                                model::correct_seam(n, rows, trace);
                                return all(rows);
                              },
                              [=](const Numbers<double>& x, const Numbers<double>& w) {
                                model::SeamRows<double> before, rows, bar;
                                model::SeamTrace<double> trace;
                                read(Reader<double>{x}, before);
                                read(Reader<double>{w}, bar);
                                rows = before;
                                model::correct_seam(n, rows, trace);
                                model::correct_seam_pullback(n, before, trace, bar);
                                return all(bar);
                              }};
    Numbers<double> x;
    append_row(x, count, 0.0, 0.0, 1.0, random);
    for (int row = 0; row < 2; ++row) append_row(x, count, 0.2, 1.0, 0.0, random);
    expect_adjoint(stage, x, random);
  }
}

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
