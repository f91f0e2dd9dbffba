#include "explore/face_meter.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

constexpr double cubic_mm_per_cubic_m = 1e9;
constexpr int highest_low_degree = 5;
constexpr int jet_count = 3;  // S, Su, Sv

const double* net_of(const model::Face& face, const double* nets) { return nets + 3 * face.net; }
const double* blend_of(const model::Face& face, const double* nets) {
  return face.blend < 0 ? nullptr : nets + 3 * face.blend;
}

// Integral of z n_z over the summed part of a face, from the jets at its nodes.
double height_integral(const model::FaceRule& rule, const double* jets) {
  const int n = rule.nodes, all = n * n;
  const double *z = jets + 2 * all, *xu = jets + 3 * all, *yu = jets + 4 * all,
               *xv = jets + 6 * all, *yv = jets + 7 * all;
  double sum = 0.0;
  for (int kv = 0; kv < n; ++kv) {
    double strip = 0.0;
    for (int ku = 0; ku < n; ++ku) {
      const int k = kv * n + ku;
      strip += rule.weights_u[ku] * z[k] * (xu[k] * yv[k] - yu[k] * xv[k]);
    }
    sum += rule.weights_v[kv] * strip;
  }
  return sum;
}

}  // namespace

SampledFaces::SampledFaces(const model::BodyPlan& plan, int nodes, int nodes_high) {
  for (const model::Face& face : plan.body_faces) {
    const model::Range range = model::summed_range(face);
    const bool high = std::max(face.degree_u, face.degree_v) > highest_low_degree;
    const auto key = std::make_pair(2 * int(range) + (face.blend >= 0 ? 1 : 0),
                                    std::make_pair(face.degree_u, face.degree_v));
    const auto [entry, is_new] = tables_.try_emplace(
        key, face.degree_u, face.degree_v, high ? nodes_high : nodes, range, face.blend >= 0);
    list_.push_back({&face, &entry->second.rule()});
  }
}

FoldMeter::FoldMeter(const model::BodyPlan& plan)
    : faces_(plan, 8, 8), kernels_(&model::kernels(model::best_isa())) {}

int FoldMeter::measure(const double* nets, int& first) const {
  // Any angle above 90 degrees counts.
  constexpr model::FoldOptions options{0.0};
  int count = 0;
  first = -1;
  for (std::size_t f = 0; f < faces_.list().size(); ++f) {
    const auto& [face, rule] = faces_.list()[f];
    if (!(kernels_->fold(*rule, net_of(*face, nets), blend_of(*face, nets), options) > 0.0))
      continue;
    if (first < 0) first = int(f);
    count += face->central ? 1 : 2;
  }
  return count;
}

// Eight nodes are exact to degree 5, where z n_z has degree 14.
VolumeMeter::VolumeMeter(const model::BodyPlan& plan)
    : faces_(plan, 8, 16), kernels_(&model::kernels(model::best_isa())) {
  int nodes = 0;
  for (const SampledFace& sampled : faces_.list()) nodes = std::max(nodes, sampled.rule->nodes);
  jets_.resize(std::size_t(3 * jet_count * nodes * nodes));
}

double VolumeMeter::measure(const double* nets) {
  double sum = 0.0;
  for (const auto& [face, rule] : faces_.list()) {
    kernels_->jets(*rule, net_of(*face, nets), blend_of(*face, nets), 1, jets_.data());
    const double integral = height_integral(*rule, jets_.data());
    sum += face->inward ? -integral : integral;
  }
  return 2.0 * sum / cubic_mm_per_cubic_m;
}

}  // namespace bodyline::explore
