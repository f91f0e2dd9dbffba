#include <ceres/ceres.h>

#include "bench/peers/fit_peers.hpp"

namespace bodyline::bench {
namespace {

void bernstein(int degree, double t, double* b) {
  b[0] = 1.0;
  for (int n = 0; n < degree; ++n) {
    b[n + 1] = t * b[n];
    for (int k = n; k > 0; --k) b[k] = (1.0 - t) * b[k] + t * b[k - 1];
    b[0] *= 1.0 - t;
  }
}

// One residual and its row of the Jacobian.
void point_row(const FitFace& face, std::size_t k, const double* net, double* residual,
               double* row) {
  double bu[8], bv[8];
  bernstein(face.degree_u, face.parameters[k][0], bu);
  bernstein(face.degree_v, face.parameters[k][1], bv);
  const Eigen::Vector3d& n = face.normals[k];
  double sum = -n.dot(face.targets[k]);
  for (int i = 0, at = 0; i <= face.degree_u; ++i) {
    for (int j = 0; j <= face.degree_v; ++j) {
      const double b = bu[i] * bv[j];
      for (int c = 0; c < 3; ++c, ++at) {
        sum += b * n[c] * net[at];
        if (row) row[at] = b * n[c];
      }
    }
  }
  *residual = sum;
}

class FaceCost final : public ceres::CostFunction {
 public:
  explicit FaceCost(const FitFace& face) : face_(face) {
    set_num_residuals(int(face.normals.size()));
    mutable_parameter_block_sizes()->push_back(int(face.net.size()));
  }
  bool Evaluate(const double* const* nets, double* residuals, double** jacobians) const override {
    const std::size_t width = face_.net.size();
    for (std::size_t k = 0; k < face_.normals.size(); ++k) {
      double* const row = jacobians && jacobians[0] ? jacobians[0] + k * width : nullptr;
      point_row(face_, k, nets[0], residuals + k, row);
    }
    return true;
  }

 private:
  const FitFace& face_;
};

class PointCost final : public ceres::CostFunction {
 public:
  PointCost(const FitFace& face, std::size_t k) : face_(face), k_(k) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(int(face.net.size()));
  }
  bool Evaluate(const double* const* nets, double* residuals, double** jacobians) const override {
    point_row(face_, k_, nets[0], residuals, jacobians ? jacobians[0] : nullptr);
    return true;
  }

 private:
  const FitFace& face_;
  std::size_t k_;
};

class SquaresCost final : public ceres::CostFunction {
 public:
  explicit SquaresCost(FitSquares squares) : squares_(std::move(squares)) {
    set_num_residuals(int(squares_.root.rows()));
    mutable_parameter_block_sizes()->push_back(int(squares_.root.cols()));
  }
  bool Evaluate(const double* const* nets, double* residuals, double** jacobians) const override {
    const Eigen::MatrixXd& root = squares_.root;
    const Eigen::Map<const Eigen::VectorXd> x(nets[0], root.cols());
    Eigen::Map<Eigen::VectorXd>(residuals, root.rows()) = root * x - squares_.target;
    if (jacobians && jacobians[0]) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], root.rows(), root.cols()) = root;
    }
    return true;
  }

 private:
  FitSquares squares_;
};

}  // namespace

struct CeresFit::Impl {
  std::vector<FitFace> faces;
  std::vector<std::vector<double>> nets;
  ceres::Problem problem;
};

CeresFit::CeresFit(std::vector<FitFace> faces, Blocks blocks) : impl_(std::make_unique<Impl>()) {
  impl_->faces = std::move(faces);
  for (const FitFace& face : impl_->faces) impl_->nets.push_back(face.net);
  for (std::size_t f = 0; f < impl_->faces.size(); ++f) {
    const FitFace& face = impl_->faces[f];
    double* const net = impl_->nets[f].data();
    if (blocks == Blocks::one_a_face) {
      impl_->problem.AddResidualBlock(new FaceCost(face), nullptr, net);
      continue;
    }
    for (std::size_t k = 0; k < face.normals.size(); ++k)
      impl_->problem.AddResidualBlock(new PointCost(face, k), nullptr, net);
  }
}

CeresFit::CeresFit(const std::vector<FitSquares>& squares, std::vector<FitFace> faces)
    : impl_(std::make_unique<Impl>()) {
  impl_->faces = std::move(faces);
  for (const FitFace& face : impl_->faces) impl_->nets.push_back(face.net);
  for (std::size_t f = 0; f < squares.size(); ++f)
    impl_->problem.AddResidualBlock(new SquaresCost(squares[f]), nullptr, impl_->nets[f].data());
}
CeresFit::~CeresFit() = default;

double CeresFit::step() {
  for (std::size_t f = 0; f < impl_->faces.size(); ++f) impl_->nets[f] = impl_->faces[f].net;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 1;
  options.num_threads = 2;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &impl_->problem, &summary);
  return summary.final_cost;
}

}  // namespace bodyline::bench
