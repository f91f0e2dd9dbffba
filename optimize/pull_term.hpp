#pragma once

#include <vector>

#include "model/body_plan.hpp"
#include "model/kernels.hpp"
#include "model/net_term.hpp"
#include "optimize/pull_moments.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::optimize {

/// Weighted mean of squared distances of points (of a scan, an outline or a line) from their faces,
/// mm^2, with the parameters of the matches held (docs/fitting.md). However many points, a face
/// keeps only the moments of them that its least squares need. Pillar feet, whose Gregory terms
/// have none, are left to their neighbours.
class PullTerm : public model::NetTerm {
 public:
  PullTerm(const model::BodyPlan& plan, model::Stage stage, model::Isa isa = model::best_isa());

  /// Takes new points; `pulls` belong to `matches` one by one. The mean counts `total_weight`, the
  /// sum of the traces of W unless given. Runs on the threads of oneTBB, with the same bits for any
  /// number of them.
  void set(const std::vector<Match>& matches, const std::vector<MatchPull>& pulls,
           double total_weight = 0.0);
  /// The same from moments by face.
  void set(const std::vector<FaceMoments>& moments, double total_weight = 0.0);

  model::Stage stage() const override { return stage_; }
  double value(const double* nets, double scale, double* nets_bar) override;
  Eigen::Index residual_count() const override { return rows_; }
  void residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) override;

 private:
  // x'Hx - 2g'x + c over the numbers of one face's net.
  struct FaceSquares {
    int net = 0;  // offset in numbers
    Eigen::MatrixXd hessian;
    Eigen::VectorXd slope;
    double constant = 0.0;
    // The same as |R x - y|^2 + rest, made when residuals are first asked for.
    Eigen::MatrixXd root;
    Eigen::VectorXd root_target;
    double rest = 0.0;
  };
  void factorize();

  const model::BodyPlan* plan_;
  model::Stage stage_;
  const model::Kernels* kernels_;
  std::vector<FaceSquares> faces_;  // those with points
  Eigen::Index rows_ = 0, columns_ = 0;
  Eigen::VectorXd product_;  // H x of the face in hand
  bool factorized_ = false;
};

}  // namespace bodyline::optimize
