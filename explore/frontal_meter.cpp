#include "explore/frontal_meter.hpp"

#include <algorithm>
#include <cmath>

#include "model/bernstein.hpp"
#include "model/factors.hpp"
#include "model/gregory_blend.hpp"

namespace bodyline::explore {
namespace {

constexpr int cells = 16, lines = cells + 1;
constexpr int heights = 512;

Eigen::MatrixXd basis_at_lines(int degree) {
  Eigen::MatrixXd basis(lines, degree + 1);
  for (int k = 0; k < lines; ++k) {
    const model::BernsteinJet jet = model::bernstein(degree, double(k) / cells);
    for (int i = 0; i <= degree; ++i) basis(k, i) = jet.d[0][i];
  }
  return basis;
}

}  // namespace

FrontalMeter::FrontalMeter(const model::BodyPlan& plan)
    : plan_(&plan), blend_(lines, lines), y_(lines, lines), z_(lines, lines), half_width_(heights) {
  for (const model::Face& face : plan.body_faces) {
    for (const int degree : {face.degree_u, face.degree_v})
      bases_.try_emplace(degree, basis_at_lines(degree));
  }
  for (int i = 0; i < lines; ++i) {
    for (int j = 0; j < lines; ++j)
      blend_(i, j) = model::blend_jet(double(i) / cells, double(j) / cells)[0];
  }
}

void FrontalMeter::sample(const model::Face& face, const double* nets) {
  // Of a net the coordinates of a kind lie three numbers apart, v fastest.
  using Net =
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>, 0,
                 Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;
  const Eigen::MatrixXd &in_u = bases_.at(face.degree_u), &in_v = bases_.at(face.degree_v);
  Eigen::Matrix<double, lines, Eigen::Dynamic, 0, lines, model::max_degree + 1> half;
  const auto fill = [&](int axis, Eigen::MatrixXd& out) {
    const Net net(nets + 3 * face.net + axis, face.degree_u + 1, face.degree_v + 1,
                  Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>(3 * (face.degree_v + 1), 3));
    half = in_u.lazyProduct(net);
    out = half.lazyProduct(in_v.transpose());
    if (face.blend >= 0) out += nets[3 * face.blend + axis] * blend_;
  };
  fill(1, y_);
  fill(2, z_);
}

// Widens the body at the heights that the line between two sampled points crosses.
void FrontalMeter::add_segment(int from, int to) {
  double z0 = (z_.data()[from] - bottom_) / step_, z1 = (z_.data()[to] - bottom_) / step_;
  double y0 = std::abs(y_.data()[from]), y1 = std::abs(y_.data()[to]);
  if (z0 > z1) {
    std::swap(z0, z1);
    std::swap(y0, y1);
  }
  const int first = std::max(0, int(std::ceil(z0 - 0.5)));
  const int last = std::min(heights - 1, int(std::floor(z1 - 0.5)));
  const double slope = z1 > z0 ? (y1 - y0) / (z1 - z0) : 0.0;
  for (int row = first; row <= last; ++row)
    half_width_[row] = std::max(half_width_[row], y0 + (row + 0.5 - z0) * slope);
}

double FrontalMeter::measure(const double* nets, const BodyReach& reach) {
  std::fill(half_width_.begin(), half_width_.end(), 0.0);
  bottom_ = reach.bottom;
  step_ = reach.height() / heights;
  // A body that is not finite or has no height shows nothing.
  if (!(step_ > 0.0) || !std::isfinite(step_)) return NAN;
  for (const model::Face& face : plan_->body_faces) {
    sample(face, nets);
    for (int i = 0; i < lines; ++i) {
      for (int j = 0; j < lines; ++j) {
        const int at = i + j * lines;
        if (i < cells) add_segment(at, at + 1);
        if (j < cells) add_segment(at, at + lines);
      }
    }
  }
  double sum = 0.0;
  for (const double half : half_width_) sum += half;
  return 2.0 * sum * step_ / model::square_mm_per_square_m;
}

}  // namespace bodyline::explore
