#include "explore/face_meter.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

constexpr double cubic_mm_per_cubic_m = 1e9;
constexpr int highest_low_degree = 5;
constexpr int jet_count = 3;  // S, Su, Sv
constexpr int fold_nodes = 8;

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

// Whether a normal at a node points away from the mean normal; those that have lost their direction
// to rounding, next to a degenerate point, do not count.
bool is_folded(const model::FaceRule& rule, const double* jets) {
  constexpr double shortest = 1e-6;  // of the mean, as in model/check_fold.cpp
  constexpr int all = fold_nodes * fold_nodes;
  const double *xu = jets + 3 * all, *yu = xu + all, *zu = yu + all, *xv = zu + all, *yv = xv + all,
               *zv = yv + all;
  double normal[3][all];
  for (int k = 0; k < all; ++k) {
    normal[0][k] = yu[k] * zv[k] - zu[k] * yv[k];
    normal[1][k] = zu[k] * xv[k] - xu[k] * zv[k];
    normal[2][k] = xu[k] * yv[k] - yu[k] * xv[k];
  }
  double mean[3] = {0.0, 0.0, 0.0};
  for (int c = 0; c < 3; ++c) {
    for (int kv = 0; kv < fold_nodes; ++kv) {
      double strip = 0.0;
      for (int ku = 0; ku < fold_nodes; ++ku)
        strip += rule.weights_u[ku] * normal[c][kv * fold_nodes + ku];
      mean[c] += rule.weights_v[kv] * strip;
    }
  }
  const double limit =
      shortest * shortest * (mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
  int away = 0;
  for (int k = 0; k < all; ++k) {
    const double x = normal[0][k], y = normal[1][k], z = normal[2][k];
    away += (x * mean[0] + y * mean[1] + z * mean[2] < 0.0) & (x * x + y * y + z * z > limit);
  }
  return away > 0;
}

}  // namespace

SampledFaces::SampledFaces(const model::BodyPlan& plan, int nodes, int nodes_high,
                           model::FaceTables::MakeRule make_rule) {
  for (const model::Face& face : plan.body_faces) {
    const model::Range range = model::summed_range(face);
    const bool high = std::max(face.degree_u, face.degree_v) > highest_low_degree;
    const auto key = std::make_pair(2 * int(range) + (face.blend >= 0 ? 1 : 0),
                                    std::make_pair(face.degree_u, face.degree_v));
    const auto [entry, is_new] =
        tables_.try_emplace(key, face.degree_u, face.degree_v, high ? nodes_high : nodes, range,
                            face.blend >= 0, make_rule);
    list_.push_back({&face, &entry->second.rule()});
  }
}

std::vector<double> SampledFaces::room() const {
  int nodes = 0;
  for (const SampledFace& sampled : list_) nodes = std::max(nodes, sampled.rule->nodes);
  return std::vector<double>(std::size_t(3 * jet_count * nodes * nodes));
}

FoldMeter::FoldMeter(const model::BodyPlan& plan)
    : faces_(plan, fold_nodes, fold_nodes, model::lobatto_rule),
      kernels_(&model::kernels(model::best_isa())),
      jets_(faces_.room()) {}

int FoldMeter::measure(const double* nets, int& first) {
  int count = 0;
  first = -1;
  for (std::size_t f = 0; f < faces_.list().size(); ++f) {
    const auto& [face, rule] = faces_.list()[f];
    kernels_->jets(*rule, net_of(*face, nets), blend_of(*face, nets), 1, jets_.data());
    if (!is_folded(*rule, jets_.data())) continue;
    if (first < 0) first = int(f);
    count += face->central ? 1 : 2;
  }
  return count;
}

// Eight nodes are exact to degree 5, where z n_z has degree 14.
VolumeMeter::VolumeMeter(const model::BodyPlan& plan)
    : faces_(plan, 8, 16, model::gauss_rule),
      kernels_(&model::kernels(model::best_isa())),
      jets_(faces_.room()) {}

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
