#include "optimize/energy_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "model/face_selection.hpp"
#include "model/factors.hpp"
#include "model/net_jacobian.hpp"
#include "optimize/face_residuals.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_energy(model::TermKind kind) {
  return kind == model::TermKind::bending || kind == model::TermKind::variation;
}

// Rows of the residual vector that come from one energy on one face.
struct FaceRows {
  double weight = 1.0;
  bool times_area = false;
  FaceResiduals residuals;
  MatrixXd triangle;
};

// Rows that come from a term on the nets.
struct NetRows {
  double weight = 1.0;
  std::shared_ptr<model::NetTerm> term;
  model::NetTerm::Jacobian jacobian;
};

// One row, the square root of a term.
struct RootRow {
  double weight = 1.0;
  std::unique_ptr<model::Evaluator> term;  // alone, with weight 1
};

}  // namespace

struct EnergyResiduals::State {
  explicit State(model::Evaluator& given);
  void add_term(const model::Term& term);
  void add_energy(const model::Term& term);
  std::unique_ptr<model::Evaluator> single_term(const model::Term& term) const;
  MatrixXd needed_net_jacobian();
  void evaluate_blocks(double area_value, VectorXd& residual, bool with_jacobian);
  void evaluate_roots(const VectorXd& x, VectorXd& residual, MatrixXd* jacobian);
  void chain_blocks(double area_value, const VectorXd& area_gradient, const VectorXd& residual,
                    MatrixXd& jacobian);

  model::Evaluator* evaluator;
  std::vector<FaceRows> faces;
  std::vector<NetRows> nets;
  std::vector<RootRow> roots;
  std::unique_ptr<model::Evaluator> area;  // multiplies the variation
  Index rows = 0;
};

std::unique_ptr<model::Evaluator> EnergyResiduals::State::single_term(
    const model::Term& term) const {
  model::EvaluatorOptions options = evaluator->options();
  options.terms = {term};
  options.terms.front().weight = 1.0;
  options.net_terms.clear();
  return std::make_unique<model::Evaluator>(evaluator->shared_context(), evaluator->selected(),
                                            options);
}

EnergyResiduals::State::State(model::Evaluator& given) : evaluator(&given) {
  for (const model::Term& term : given.options().terms) add_term(term);
  for (const model::WeightedNetTerm& extra : given.options().net_terms) {
    if (extra.weight < 0.0)
      throw std::invalid_argument(
          "the weight of a term is negative; a sum of squares needs 0 or more");
    nets.push_back({extra.weight, extra.term, {}});
  }
  for (const FaceRows& block : faces) rows += block.residuals.rows();
  for (const NetRows& block : nets) rows += block.term->residual_count();
  rows += Index(roots.size());
}

void EnergyResiduals::State::add_term(const model::Term& term) {
  if (term.weight < 0.0) {
    throw std::invalid_argument("the weight of " + model::term_name(term.kind) +
                                " is negative; a sum of squares needs weights of 0 or more");
  }
  if (is_energy(term.kind)) {
    add_energy(term);
  } else if (term.kind == model::TermKind::closeness) {
    nets.push_back({term.weight, evaluator->closeness(), {}});
  } else {
    roots.push_back({term.weight, single_term(term)});
  }
}

void EnergyResiduals::State::add_energy(const model::Term& term) {
  const bool variation = term.kind == model::TermKind::variation;
  for (const model::Face* face :
       model::choose_faces(evaluator->context().plan, term.stage, term.faces)) {
    faces.push_back({term.weight, variation, {evaluator->options(), term.kind, *face}, {}});
  }
  if (variation) area = single_term({model::TermKind::area, 1.0, term.stage, {}});
}

// d nets / d variables where the blocks' Jacobians have columns.
MatrixXd EnergyResiduals::State::needed_net_jacobian() {
  std::vector<char> needed(3 * std::size_t(evaluator->context().plan.point_count), 0);
  for (const FaceRows& block : faces) {
    for (const Index k : block.residuals.coordinates()) needed[k] = 1;
  }
  for (const NetRows& block : nets) {
    for (Index k = 0; k < block.jacobian.nonZeros(); ++k)
      needed[block.jacobian.innerIndexPtr()[k]] = 1;
  }
  std::vector<Index> wanted;
  for (std::size_t k = 0; k < needed.size(); ++k) {
    if (needed[k]) wanted.push_back(Index(k));
  }
  return model::net_jacobian(*evaluator, wanted);
}

// Residuals of the blocks, and their derivatives by the nets, at the evaluator's nets.
void EnergyResiduals::State::evaluate_blocks(double area_value, VectorXd& residual,
                                             bool with_jacobian) {
  const double* points = evaluator->nets();
  Index row = 0;
  for (FaceRows& block : faces) {
    const double factor = model::both_halves * block.weight * (block.times_area ? area_value : 1.0);
    block.residuals.evaluate(points, factor, residual.segment(row, block.residuals.rows()),
                             with_jacobian ? &block.triangle : nullptr);
    row += block.residuals.rows();
  }
  for (NetRows& block : nets) {
    auto own = residual.segment(row, block.term->residual_count());
    block.term->residuals(points, own, with_jacobian ? &block.jacobian : nullptr);
    own *= std::sqrt(block.weight);
    row += own.size();
  }
}

void EnergyResiduals::State::evaluate_roots(const VectorXd& x, VectorXd& residual,
                                            MatrixXd* jacobian) {
  Index row = rows - Index(roots.size());
  VectorXd gradient(evaluator->size());
  for (const RootRow& root : roots) {
    const double value = root.term->evaluate(x, jacobian ? &gradient : nullptr);
    residual[row] = std::sqrt(root.weight * value);
    if (jacobian) {
      const double slope = residual[row] > 0.0 ? 0.5 * root.weight / residual[row] : 0.0;
      jacobian->row(row) = slope * gradient.transpose();
    }
    ++row;
  }
}

// From the blocks' derivatives by the nets to rows of the Jacobian.
void EnergyResiduals::State::chain_blocks(double area_value, const VectorXd& area_gradient,
                                          const VectorXd& residual, MatrixXd& jacobian) {
  const MatrixXd by_variables = needed_net_jacobian();
  Index row = 0;
  for (const FaceRows& block : faces) {
    const auto own = residual.segment(row, block.residuals.rows());
    auto target = jacobian.middleRows(row, own.size());
    target.noalias() = block.triangle * by_variables(block.residuals.coordinates(), Eigen::all);
    // r = sqrt(area) rho: the area's own derivative.
    if (block.times_area) target += (0.5 / area_value) * own * area_gradient.transpose();
    row += own.size();
  }
  for (const NetRows& block : nets) {
    const Index count = block.term->residual_count();
    jacobian.middleRows(row, count) = std::sqrt(block.weight) * (block.jacobian * by_variables);
    row += count;
  }
}

EnergyResiduals::EnergyResiduals(model::Evaluator& evaluator)
    : state_(std::make_unique<State>(evaluator)) {}
EnergyResiduals::~EnergyResiduals() = default;

Eigen::Index EnergyResiduals::count() const { return state_->rows; }

void EnergyResiduals::evaluate(const VectorXd& x, VectorXd& residual, MatrixXd* jacobian) {
  State& s = *state_;
  s.evaluator->build(x);
  double area = 1.0;
  VectorXd area_gradient(s.evaluator->size());
  if (s.area) {
    // The area term is in m^2, the variation in 1/mm^2.
    area = model::square_mm_per_square_m * s.area->evaluate(x, jacobian ? &area_gradient : nullptr);
    area_gradient *= model::square_mm_per_square_m;
  }
  s.evaluate_blocks(area, residual, jacobian != nullptr);
  s.evaluate_roots(x, residual, jacobian);
  if (jacobian) s.chain_blocks(area, area_gradient, residual, *jacobian);
}

}  // namespace bodyline::optimize
