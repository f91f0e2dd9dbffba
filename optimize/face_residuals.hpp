#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/evaluator.hpp"
#include "model/face_rule.hpp"

namespace bodyline::optimize {

/// One energy on one face as a sum of squares: three (bending) or two (variation) residuals a node,
/// compressed by a QR decomposition to as many rows as the face's net has coordinates, and one.
class FaceResiduals {
 public:
  /// `kind` is bending or variation.
  FaceResiduals(const model::EvaluatorOptions& options, model::TermKind kind,
                const model::Face& face);

  Eigen::Index rows() const { return Eigen::Index(coordinates_.size()) + 1; }

  /// The numbers of the arena of nets that it depends on: the face's net, and its blend.
  const std::vector<Eigen::Index>& coordinates() const { return coordinates_; }

  /// Residuals at the nets, their squares times `factor`, into rows() entries. `triangle`, when not
  /// null, becomes rows() by coordinates().size(): their derivative, up to a rotation of the rows.
  void evaluate(const double* nets, double factor, Eigen::Ref<Eigen::VectorXd> residual,
                Eigen::MatrixXd* triangle) const;

 private:
  void at_nodes(const double* nets, double factor, Eigen::VectorXd& residual,
                Eigen::MatrixXd* jacobian) const;

  const model::Kernels* kernels_;
  model::TermKind kind_;
  int net_ = 0, blend_ = -1;  // offsets in numbers
  std::unique_ptr<model::FaceTables> tables_;
  std::vector<Eigen::Index> coordinates_;
};

}  // namespace bodyline::optimize
