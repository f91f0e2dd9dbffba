#pragma once

#include <vector>

#include "model/body_plan.hpp"

namespace bodyline::explore {

/// How far a body reaches, mm.
struct BodyReach {
  double front = 0.0, rear = 0.0;  ///< least and largest x
  double side = 0.0;               ///< half the width
  double bottom = 0.0, top = 0.0;  ///< least and largest z
  double length() const { return rear - front; }
  double width() const { return 2.0 * side; }
  double height() const { return top - bottom; }
};

/// Measures how far bodies reach, as model/measures.hpp does but some thousand times faster: each
/// coordinate of a face lies within its net's, so that few faces need a closer look; there the
/// patch is split where its Bernstein coefficients do not rise or fall throughout.
class BoxMeter {
 public:
  /// `plan` must outlive it.
  explicit BoxMeter(const model::BodyPlan& plan);

  /// Of the faces of the closed body with these nets, each number less than 1e-6 mm inside the true
  /// one. Allocates nothing.
  BodyReach measure(const double* nets);

  struct Bounds {
    double low[3], high[3];
  };

 private:
  void bound_faces(const double* nets);
  double furthest(const double* nets, int axis, double sign) const;

  const model::BodyPlan* plan_;
  std::vector<Bounds> bounds_;  // of each face's net
  Bounds corners_;              // of the corners of all nets, which are points of faces
};

}  // namespace bodyline::explore
