#include "model/sq_coons.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/basis.hpp"

namespace bodyline::model {
namespace {

// Points within 1000 mm, sums of some dozens of products: 1000 * eps * 100.
constexpr double rounding = 1e-10;

using Net = std::vector<Vec3<double>>;

struct Degrees {
  int m, n;
};

class SqCoons : public testing::TestWithParam<Degrees> {
 protected:
  SqCoons() {
    std::normal_distribution<double> point(0.0, 300.0), value(0.0, 2.0);
    net.resize((m + 1) * (n + 1));
    for (Vec3<double>& p : net) p = {point(random), point(random), point(random)};
    for (int k = 0; k < m - 1; ++k) shape_u.push_back(value(random));
    for (int k = 0; k < n - 1; ++k) shape_v.push_back(value(random));
  }
  const int m = GetParam().m, n = GetParam().n;
  std::mt19937 random{unsigned(10 * GetParam().m + GetParam().n)};
  Net net;
  std::vector<double> shape_u, shape_v;
};
INSTANTIATE_TEST_SUITE_P(Degrees, SqCoons,
                         testing::Values(Degrees{3, 3}, Degrees{5, 3}, Degrees{4, 5}, Degrees{2, 4},
                                         Degrees{6, 3}, Degrees{9, 2}));

Eigen::MatrixXd coordinate(const Net& net, int m, int n, int c) {
  Eigen::MatrixXd p(m + 1, n + 1);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) p(i, j) = (&net[i * (n + 1) + j].x)[c];
  }
  return p;
}

// The Coons net of the boundary of p.
Eigen::MatrixXd coons(const Eigen::MatrixXd& p) {
  const Eigen::Index m = p.rows() - 1, n = p.cols() - 1;
  Eigen::MatrixXd q(m + 1, n + 1);
  for (Eigen::Index i = 0; i <= m; ++i) {
    for (Eigen::Index j = 0; j <= n; ++j) {
      const double u = double(i) / double(m), v = double(j) / double(n);
      q(i, j) = (1 - u) * p(0, j) + u * p(m, j) + (1 - v) * p(i, 0) + v * p(i, n) -
                (1 - u) * ((1 - v) * p(0, 0) + v * p(0, n)) - u * ((1 - v) * p(m, 0) + v * p(m, n));
    }
  }
  return q;
}

// R1 + R2 - T, eqs. (7)-(11), with conversion matrices of the basis and nothing cancelled.
Eigen::MatrixXd superposition(const Eigen::MatrixXd& boundary, const Eigen::MatrixXd& mu,
                              const Eigen::MatrixXd& mv) {
  const Eigen::MatrixXd p = coons(boundary);
  const Eigen::MatrixXd along_v = p * mv, along_u = mu.transpose() * p;
  Eigen::MatrixXd t = Eigen::MatrixXd::Zero(p.rows(), p.cols());
  t.row(0) = along_v.row(0);
  t.row(p.rows() - 1) = along_v.row(p.rows() - 1);
  t.col(0) = along_u.col(0);
  t.col(p.cols() - 1) = along_u.col(p.cols() - 1);
  return along_v + along_u - coons(t);
}

TEST_P(SqCoons, IsTheSuperpositionOfItsThreeSurfaces) {
  const Net given = net;
  sq_coons(m, n, net.data(), shape_u.data(), shape_v.data());
  for (int c = 0; c < 3; ++c) {
    const Eigen::MatrixXd expected =
        superposition(coordinate(given, m, n, c), GeBezierBasis(m).conversion(shape_u),
                      GeBezierBasis(n).conversion(shape_v));
    EXPECT_LT((coordinate(net, m, n, c) - expected).cwiseAbs().maxCoeff(), rounding);
  }
}

TEST_P(SqCoons, LeavesItsBoundaryAlone) {
  const Net given = net;
  sq_coons(m, n, net.data(), shape_u.data(), shape_v.data());
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      if (i % m != 0 && j % n != 0) continue;
      const int k = i * (n + 1) + j;
      EXPECT_EQ(net[k].x, given[k].x);
      EXPECT_EQ(net[k].y, given[k].y);
      EXPECT_EQ(net[k].z, given[k].z);
    }
  }
}

TEST_P(SqCoons, PullbackIsTheAdjointOfItsLinearPart) {
  // The net is affine in the boundary for fixed shapes, and in the shapes for a fixed boundary.
  sq_coons(m, n, net.data(), shape_u.data(), shape_v.data());
  std::normal_distribution<double> value(0.0, 1.0);
  Net bar(net.size());
  for (Vec3<double>& b : bar) b = {value(random), value(random), value(random)};
  Net net_bar = bar;
  std::vector<double> u_bar(m - 1, 0.0), v_bar(n - 1, 0.0);
  sq_coons_pullback(m, n, net.data(), shape_u.data(), shape_v.data(), net_bar.data(), u_bar.data(),
                    v_bar.data());
  std::vector<double> du(m - 1), dv(n - 1);
  for (double& d : du) d = value(random);
  for (double& d : dv) d = value(random);
  Net moved = net;
  Net direction(net.size());
  double predicted = 0.0;
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      if (i % m != 0 && j % n != 0) continue;
      const int k = i * (n + 1) + j;
      direction[k] = {value(random), value(random), value(random)};
      predicted += dot(net_bar[k], direction[k]);
    }
  }
  std::vector<double> su = shape_u, sv = shape_v;
  for (std::size_t k = 0; k < du.size(); ++k) su[k] += du[k], predicted += u_bar[k] * du[k];
  for (std::size_t k = 0; k < dv.size(); ++k) sv[k] += dv[k], predicted += v_bar[k] * dv[k];
  // First the shapes at the old boundary, then the boundary at the old shapes: no product of both
  // moves.
  double actual = 0.0;
  sq_coons(m, n, moved.data(), su.data(), sv.data());
  for (std::size_t k = 0; k < net.size(); ++k) actual += dot(bar[k], moved[k] - net[k]);
  moved = net;
  for (std::size_t k = 0; k < net.size(); ++k) moved[k] += direction[k];
  sq_coons(m, n, moved.data(), shape_u.data(), shape_v.data());
  for (std::size_t k = 0; k < net.size(); ++k) actual += dot(bar[k], moved[k] - net[k]);
  EXPECT_NEAR(actual, predicted, 1e-12 * (1.0 + std::abs(predicted)) * 1e3);
}

}  // namespace
}  // namespace bodyline::model
