#include "optimize/scan_term.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "model/bernstein.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int chunk = 4096;  // points whose moments are added in one go; the sums' order

// Sums over some points of one face.
struct Moments {
  std::vector<double> second, first;
  double constant = 0.0;

  void add(const Moments& other) {
    for (std::size_t k = 0; k < second.size(); ++k) second[k] += other.second[k];
    for (std::size_t k = 0; k < first.size(); ++k) first[k] += other.first[k];
    constant += other.constant;
  }
};

Moments sum_moments(const model::Kernels& kernels, const model::Face& face,
                    const std::vector<Match>& matches, const std::vector<MatchPull>& pulls,
                    const int* begin, const int* end) {
  const int stride = model::moment_stride(face.degree_v);
  Moments sums;
  sums.second.assign(std::size_t(2 * face.degree_u + 1) * stride, 0.0);
  sums.first.assign(std::size_t(3) * (face.degree_u + 1) * (face.degree_v + 1), 0.0);
  std::vector<model::MomentPoint> points;
  points.reserve(end - begin);
  for (const int* k = begin; k != end; ++k) {
    const Eigen::Matrix3d& w = pulls[*k].weight;
    const Vector3d pulled = w * pulls[*k].target;
    sums.constant += pulls[*k].target.dot(pulled);
    points.push_back({matches[*k].u,
                      matches[*k].v,
                      {w(0, 0), w(0, 1), w(0, 2), w(1, 1), w(1, 2), w(2, 2)},
                      {pulled[0], pulled[1], pulled[2]}});
  }
  kernels.add_moments(face.degree_u, face.degree_v, points.data(), int(points.size()), stride,
                      sums.second.data(), sums.first.data());
  return sums;
}

// B_i B_k of degree m is this times B_{i+k} of degree 2m.
double product_factor(int degree, int i, int k) {
  return double(model::binomial(degree, i)) * double(model::binomial(degree, k)) /
         double(model::binomial(2 * degree, i + k));
}

MatrixXd hessian_of(const model::Face& face, const Moments& sums, double scale) {
  constexpr int entry[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  const int m = face.degree_u, n = face.degree_v, stride = model::moment_stride(n);
  const int points = (m + 1) * (n + 1);
  MatrixXd h(3 * points, 3 * points);
  for (int p = 0; p < points; ++p) {
    const int i = p / (n + 1), j = p % (n + 1);
    for (int q = 0; q < points; ++q) {
      const int k = q / (n + 1), l = q % (n + 1);
      const double factor = scale * product_factor(m, i, k) * product_factor(n, j, l);
      const double* const w = sums.second.data() + std::size_t(i + k) * stride + 6 * (j + l);
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) h(3 * p + a, 3 * q + b) = factor * w[entry[a][b]];
      }
    }
  }
  return h;
}

}  // namespace

ScanTerm::ScanTerm(const model::BodyPlan& plan, model::Stage stage, model::Isa isa)
    : plan_(&plan),
      stage_(stage),
      kernels_(&model::kernels(isa)),
      columns_(3 * Index(plan.point_count)) {}

void ScanTerm::set(const std::vector<Match>& matches, const std::vector<MatchPull>& pulls,
                   double total_weight) {
  const std::vector<model::Face>& faces = plan_->faces(stage_);
  std::vector<std::vector<int>> of_face(faces.size());
  double total = 0.0;
  for (int k = 0; k < int(matches.size()); ++k) {
    const double trace = pulls[k].weight.trace();
    if (!(trace > 0.0) || faces[matches[k].face].blend >= 0) continue;
    total += trace;
    of_face[matches[k].face].push_back(k);
  }
  if (total_weight > 0.0) total = total_weight;
  struct Task {
    int face, begin, end;
  };
  std::vector<Task> tasks;
  for (int f = 0; f < int(faces.size()); ++f) {
    for (int begin = 0; begin < int(of_face[f].size()); begin += chunk)
      tasks.push_back({f, begin, std::min(begin + chunk, int(of_face[f].size()))});
  }
  std::vector<Moments> sums(tasks.size());
  tbb::parallel_for(std::size_t(0), tasks.size(), [&](std::size_t t) {
    const int* const indices = of_face[tasks[t].face].data();
    sums[t] = sum_moments(*kernels_, faces[tasks[t].face], matches, pulls, indices + tasks[t].begin,
                          indices + tasks[t].end);
  });
  // Chunks of a face are added in their order.
  std::vector<std::size_t> firsts;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    if (tasks[t].begin == 0) {
      firsts.push_back(t);
    } else {
      sums[firsts.back()].add(sums[t]);
    }
  }
  faces_.assign(firsts.size(), {});
  tbb::parallel_for(std::size_t(0), firsts.size(), [&](std::size_t k) {
    const Moments& whole = sums[firsts[k]];
    const model::Face& face = faces[tasks[firsts[k]].face];
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

double ScanTerm::value(const double* nets, double scale, double* nets_bar) {
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

void ScanTerm::factorize() {
  tbb::parallel_for(std::size_t(0), faces_.size(), [&](std::size_t k) {
    FaceSquares& face = faces_[k];
    // H = V D V', so that R = D^(1/2) V'; directions that no point sees are left out.
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(face.hessian);
    const VectorXd& d = solver.eigenvalues();
    const double least = 1e-14 * std::max(d.maxCoeff(), 0.0);
    VectorXd root(d.size()), inverse(d.size());
    for (Index i = 0; i < d.size(); ++i) {
      root[i] = d[i] > least ? std::sqrt(d[i]) : 0.0;
      inverse[i] = root[i] > 0.0 ? 1.0 / root[i] : 0.0;
    }
    face.root = root.asDiagonal() * solver.eigenvectors().transpose();
    face.root_target = inverse.asDiagonal() * (solver.eigenvectors().transpose() * face.slope);
    face.rest = std::sqrt(std::max(0.0, face.constant - face.root_target.squaredNorm()));
  });
  factorized_ = true;
}

void ScanTerm::residuals(const double* nets, Eigen::Ref<VectorXd> r, Jacobian* jacobian) {
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
