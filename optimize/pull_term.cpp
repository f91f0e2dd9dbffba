#include "optimize/pull_term.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "model/bernstein.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// B_i B_k of degree m is this times B_{i+k} of degree 2m.
double product_factor(int degree, int i, int k) {
  return double(model::binomial(degree, i)) * double(model::binomial(degree, k)) /
         double(model::binomial(2 * degree, i + k));
}

MatrixXd hessian_of(const model::Face& face, const FaceMoments& sums, double scale) {
  constexpr int entry[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  const int m = face.degree_u, n = face.degree_v;
  const int stride = model::moment_stride(n), width = model::moment_width(n);
  const int points = (m + 1) * (n + 1);
  MatrixXd h(3 * points, 3 * points);
  for (int p = 0; p < points; ++p) {
    const int i = p / (n + 1), j = p % (n + 1);
    for (int q = 0; q < points; ++q) {
      const int k = q / (n + 1), l = q % (n + 1);
      const double factor = scale * product_factor(m, i, k) * product_factor(n, j, l);
      const double* const w = sums.second.data() + std::size_t(i + k) * stride + j + l;
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) h(3 * p + a, 3 * q + b) = factor * w[entry[a][b] * width];
      }
    }
  }
  return h;
}

std::vector<const FaceMoments*> with_weight(const std::vector<FaceMoments>& moments) {
  std::vector<const FaceMoments*> heeded;
  for (const FaceMoments& face : moments)
    if (face.weight > 0.0) heeded.push_back(&face);
  return heeded;
}

}  // namespace

PullTerm::PullTerm(const model::BodyPlan& plan, model::Stage stage, model::Isa isa)
    : plan_(&plan),
      stage_(stage),
      kernels_(&model::kernels(isa)),
      columns_(3 * Index(plan.point_count)) {}

void PullTerm::set(const std::vector<Match>& matches, const std::vector<MatchPull>& pulls,
                   double total_weight) {
  set(collect_moments(plan_->faces(stage_), *kernels_, matches, pulls), total_weight);
}

void PullTerm::set(const std::vector<FaceMoments>& moments, double total_weight) {
  double total = total_weight;
  if (!(total > 0.0)) {
    total = 0.0;
    for (const FaceMoments& face : moments) total += face.weight;
  }
  const std::vector<const FaceMoments*> heeded = with_weight(moments);
  faces_.assign(heeded.size(), {});
  tbb::parallel_for(std::size_t(0), heeded.size(), [&](std::size_t k) {
    const FaceMoments& whole = *heeded[k];
    const model::Face& face = plan_->faces(stage_)[whole.face];
    FaceSquares& squares = faces_[k];
    squares.net = 3 * face.net;
    squares.hessian = hessian_of(face, whole, 1.0 / total);
    squares.slope =
        Eigen::Map<const VectorXd>(whole.first.data(), Index(whole.first.size())) / total;
    squares.constant = whole.constant / total;
  });
  rows_ = 0;
  Index largest = 0;
  for (const FaceSquares& face : faces_) {
    rows_ += face.slope.size() + 1;
    largest = std::max(largest, face.slope.size());
  }
  product_.resize(largest);
  factorized_ = false;
}

double PullTerm::value(const double* nets, double scale, double* nets_bar) {
  double sum = 0.0;
  for (const FaceSquares& face : faces_) {
    const Eigen::Map<const VectorXd> x(nets + face.net, face.slope.size());
    auto product = product_.head(face.slope.size());
    product.noalias() = face.hessian * x;
    sum += x.dot(product) - 2.0 * face.slope.dot(x) + face.constant;
    if (!nets_bar) continue;
    Eigen::Map<VectorXd>(nets_bar + face.net, face.slope.size()) +=
        (2.0 * scale) * (product - face.slope);
  }
  return std::max(sum, 0.0);  // the squares cancel when the fit is exact
}

void PullTerm::factorize() {
  tbb::parallel_for(std::size_t(0), faces_.size(), [&](std::size_t k) {
    FaceSquares& face = faces_[k];
    // H = P' L D L' P, so that R = D^(1/2) L' P; directions that no point sees are left out.
    const Eigen::LDLT<MatrixXd> solver(face.hessian);
    const VectorXd d = solver.vectorD();
    const double least = 1e-14 * std::max(d.maxCoeff(), 0.0);
    VectorXd root(d.size()), inverse(d.size());
    for (Index i = 0; i < d.size(); ++i) {
      root[i] = d[i] > least ? std::sqrt(d[i]) : 0.0;
      inverse[i] = root[i] > 0.0 ? 1.0 / root[i] : 0.0;
    }
    const MatrixXd order = solver.transpositionsP() * MatrixXd::Identity(d.size(), d.size());
    face.root = root.asDiagonal() * (solver.matrixU() * order);
    face.root_target = inverse.asDiagonal() * solver.matrixL().solve(order * face.slope);
    face.rest = std::sqrt(std::max(0.0, face.constant - face.root_target.squaredNorm()));
  });
  factorized_ = true;
}

void PullTerm::residuals(const double* nets, Eigen::Ref<VectorXd> r, Jacobian* jacobian) {
  if (!factorized_) factorize();
  std::vector<Eigen::Triplet<double>> entries;
  Index row = 0;
  for (const FaceSquares& face : faces_) {
    const Index size = face.slope.size();
    const Eigen::Map<const VectorXd> x(nets + face.net, size);
    r.segment(row, size) = face.root * x - face.root_target;
    r[row + size] = face.rest;
    if (jacobian) {
      for (Index i = 0; i < size; ++i) {
        for (Index j = 0; j < size; ++j)
          entries.emplace_back(row + i, face.net + j, face.root(i, j));
      }
    }
    row += size + 1;
  }
  if (!jacobian) return;
  jacobian->resize(rows_, columns_);
  jacobian->setFromTriplets(entries.begin(), entries.end());
}

}  // namespace bodyline::optimize
