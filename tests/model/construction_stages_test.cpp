// The stages of patches alone: base nets, kept nets, seams.

#include <gtest/gtest.h>

#include "model/cut.hpp"
#include "model/seam.hpp"
#include "model/sq_coons.hpp"
#include "stage_adjoint.hpp"

namespace bodyline::testing {
namespace {

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

}  // namespace
}  // namespace bodyline::testing
