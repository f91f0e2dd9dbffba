#include "explore/edge_meter.hpp"

#include <cmath>

#include "model/check_edge.hpp"
#include "model/net_surface.hpp"

namespace bodyline::explore {
namespace {

constexpr int samples = 17;

// The larger one, NaN when either is.
double worse(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

}  // namespace

EdgeMeter::EdgeMeter(const model::Model& model, const model::BodyPlan& plan)
    : plan_(&plan), edges_(model::list_edges(model, plan, model::Stage::body)) {}

EdgeMeter::Worst EdgeMeter::measure(const double* nets) const {
  const std::vector<model::Surface> faces = model::net_surfaces(*plan_, model::Stage::body, nets);
  Worst worst;
  for (const model::BodyEdge& edge : edges_) {
    const model::EdgeDeviation deviation = model::edge_deviation(faces, edge, samples);
    worst.gap_mm = worse(worst.gap_mm, deviation.gap_mm);
    worst.kink_deg = worse(worst.kink_deg, deviation.normal_deviation_deg);
  }
  return worst;
}

}  // namespace bodyline::explore
