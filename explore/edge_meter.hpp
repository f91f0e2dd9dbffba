#pragma once

#include <vector>

#include "model/check_edge_list.hpp"

namespace bodyline::explore {

/// How well the faces of the closed body meet, at 17 places of every edge.
class EdgeMeter {
 public:
  /// `plan` must outlive it.
  EdgeMeter(const model::Model& model, const model::BodyPlan& plan);

  struct Worst {
    double gap_mm = 0.0, kink_deg = 0.0;
  };
  /// NaN where a face has no normal at an edge.
  Worst measure(const double* nets) const;

 private:
  const model::BodyPlan* plan_;
  std::vector<model::BodyEdge> edges_;
};

}  // namespace bodyline::explore
