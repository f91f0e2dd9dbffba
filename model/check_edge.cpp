#include "model/check_edge.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "model/check_edge_jet.hpp"

namespace bodyline::model {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// The larger of two, and NaN when one is.
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

EdgeJet jet_at(const std::vector<Surface>& faces, const FaceSide& side, double s) {
  return edge_jet(faces[side.face], side.side, side.reversed ? 1.0 - s : s);
}

}  // namespace

EdgeDeviation edge_deviation(const std::vector<Surface>& faces, const BodyEdge& edge, int samples) {
  EdgeDeviation worst;
  for (const SharedSide& shared : edge.sides) {
    for (int k = 0; k < samples; ++k) {
      const double s = double(k) / (samples - 1);
      const EdgeJet a = jet_at(faces, shared.a, s), b = jet_at(faces, shared.b, s);
      worst.gap_mm = larger((a.point - b.point).norm(), worst.gap_mm);
      const double angle = angle_deg(a.normal, b.normal);
      if (!(angle <= worst.normal_deviation_deg)) worst.worst_point = a.point;
      worst.normal_deviation_deg = larger(angle, worst.normal_deviation_deg);
      if (a.degenerate || b.degenerate) continue;
      worst.curvature_jump_per_mm =
          larger(std::abs(curvature_across(a) - curvature_across(b)), worst.curvature_jump_per_mm);
    }
  }
  return worst;
}

}  // namespace bodyline::model
