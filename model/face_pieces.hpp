#pragma once

#include <vector>

#include "model/face_net.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// A face of Bezier pieces, ready to be evaluated.
class FacePieces {
 public:
  explicit FacePieces(const NetFace& face);

  /// The jet at (u, v) in [0,1]^2 by the face's own parameters; where pieces meet, of the one that
  /// begins there.
  SurfaceJet jet(double u, double v, int order) const;

  /// As model::outward_normal.
  Eigen::Vector3d outward_normal(double u, double v) const;

  int pieces_u() const { return static_cast<int>(breaks_u_.size()) - 1; }
  int pieces_v() const { return static_cast<int>(breaks_v_.size()) - 1; }
  const std::vector<double>& breaks_u() const { return breaks_u_; }
  const std::vector<double>& breaks_v() const { return breaks_v_; }
  const Surface& piece(int i, int j) const { return pieces_[i * pieces_v() + j]; }
  const std::vector<Surface>& all() const { return pieces_; }

 private:
  std::vector<double> breaks_u_, breaks_v_;
  std::vector<Surface> pieces_;
};

/// The piece between breaks that holds t in [0,1], and where in it t is.
struct PiecePlace {
  int piece = 0;
  double at = 0.0, length = 1.0;
};
PiecePlace piece_place(const std::vector<double>& breaks, double t);

}  // namespace bodyline::model
