#include "explore/face_meter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/net_surface.hpp"

namespace bodyline::explore {
namespace {

constexpr double cubic_mm_per_cubic_m = 1e9;
constexpr int highest_low_degree = 5;
constexpr int jet_count = 3;  // S, Su, Sv
constexpr int fold_nodes = 8;
constexpr double shortest_normal = 1e-6;  // of the mean, as in model/check_fold.cpp
// A face is looked at more closely when a normal is turned by 80 degrees or more.
constexpr double doubtful_cosine = 0.1736;
constexpr double first_step = 0.05, last_step = 1e-3;

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

// The normal of a face that is turned most against the mean normal.
struct WorstNormal {
  Eigen::Vector3d mean;  // not of length 1
  double cosine = 1.0;
  double u = 0.0, v = 0.0;
};

// Of those at the nodes; normals that have lost their direction to rounding, next to a degenerate
// point, do not count.
WorstNormal worst_at_nodes(const model::FaceTables& tables, const double* jets) {
  constexpr int all = fold_nodes * fold_nodes;
  const model::FaceRule& rule = tables.rule();
  const double *xu = jets + 3 * all, *yu = xu + all, *zu = yu + all, *xv = zu + all, *yv = xv + all,
               *zv = yv + all;
  double normal[3][all];
  for (int k = 0; k < all; ++k) {
    normal[0][k] = yu[k] * zv[k] - zu[k] * yv[k];
    normal[1][k] = zu[k] * xv[k] - xu[k] * zv[k];
    normal[2][k] = xu[k] * yv[k] - yu[k] * xv[k];
  }
  WorstNormal worst;
  for (int c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (int kv = 0; kv < fold_nodes; ++kv) {
      double strip = 0.0;
      for (int ku = 0; ku < fold_nodes; ++ku)
        strip += rule.weights_u[ku] * normal[c][kv * fold_nodes + ku];
      sum += rule.weights_v[kv] * strip;
    }
    worst.mean[c] = sum;
  }
  const double squared = worst.mean.squaredNorm();
  const double shortest = shortest_normal * shortest_normal * squared;
  double cosines[all];
  for (int k = 0; k < all; ++k) {
    const double x = normal[0][k], y = normal[1][k], z = normal[2][k];
    const double length = x * x + y * y + z * z;
    const double along = x * worst.mean[0] + y * worst.mean[1] + z * worst.mean[2];
    cosines[k] = length > shortest ? along / std::sqrt(length * squared) : 1.0;
  }
  const int at = int(std::min_element(cosines, cosines + all) - cosines);
  worst.cosine = cosines[at];
  worst.u = tables.rule_u().nodes[at % fold_nodes];
  worst.v = tables.rule_v().nodes[at / fold_nodes];
  return worst;
}

// Goes on from the worst node, always to the worst of eight neighbours, until the cosine is
// negative or nothing is left to find.
bool folds_nearby(const model::Surface& surface, WorstNormal worst) {
  const double mean = worst.mean.norm();
  const auto cosine = [&](double u, double v) {
    const model::SurfaceJet at = jet(surface, u, v, 1);
    const Eigen::Vector3d normal = at.d[1].cross(at.d[2]);
    const double length = normal.norm();
    return length > shortest_normal * mean ? normal.dot(worst.mean) / (length * mean) : 1.0;
  };
  for (double step = first_step; step > last_step && worst.cosine >= 0.0;) {
    const WorstNormal from = worst;
    for (int k = 0; k < 9; ++k) {
      const double u = std::clamp(from.u + step * (k / 3 - 1), 0.0, 1.0);
      const double v = std::clamp(from.v + step * (k % 3 - 1), 0.0, 1.0);
      const double here = cosine(u, v);
      if (here < worst.cosine) worst = {worst.mean, here, u, v};
    }
    if (worst.cosine == from.cosine) step *= 0.5;
  }
  return worst.cosine < 0.0;
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
    list_.push_back({&face, &entry->second});
  }
}

std::vector<double> SampledFaces::room() const {
  int nodes = 0;
  for (const SampledFace& sampled : list_) nodes = std::max(nodes, sampled.tables->rule().nodes);
  return std::vector<double>(std::size_t(3 * jet_count * nodes * nodes));
}

FoldMeter::FoldMeter(const model::BodyPlan& plan)
    : faces_(plan, fold_nodes, fold_nodes, model::lobatto_rule),
      kernels_(&model::kernels(model::best_isa())),
      jets_(faces_.room()) {}

int FoldMeter::measure(const double* nets, bool any, int& first) {
  int count = 0;
  first = -1;
  for (std::size_t f = 0; f < faces_.list().size(); ++f) {
    const auto& [face, tables] = faces_.list()[f];
    kernels_->jets(tables->rule(), net_of(*face, nets), blend_of(*face, nets), 1, jets_.data());
    const WorstNormal worst = worst_at_nodes(*tables, jets_.data());
    if (!(worst.cosine < doubtful_cosine)) continue;
    if (worst.cosine >= 0.0 && !folds_nearby(model::net_surface(*face, nets), worst)) continue;
    if (first < 0) first = int(f);
    count += face->central ? 1 : 2;
    if (any) break;
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
  for (const auto& [face, tables] : faces_.list()) {
    kernels_->jets(tables->rule(), net_of(*face, nets), blend_of(*face, nets), 1, jets_.data());
    const double integral = height_integral(tables->rule(), jets_.data());
    sum += face->inward ? -integral : integral;
  }
  return 2.0 * sum / cubic_mm_per_cubic_m;
}

}  // namespace bodyline::explore
