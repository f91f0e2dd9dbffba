#include "optimize/chain_problem.hpp"

#include <limits>
#include <stdexcept>

#include "model/bezier_form.hpp"
#include "model/propagated.hpp"

namespace bodyline::optimize {
namespace {

std::vector<double> flat(const std::vector<Eigen::Vector3d>& net) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& point : net)
    numbers.insert(numbers.end(), point.begin(), point.end());
  return numbers;
}

std::vector<Eigen::Vector3d> points_of(const std::vector<double>& numbers) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t k = 0; k < numbers.size(); k += 3)
    points.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
  return points;
}

}  // namespace

ChainProblem::ChainProblem(const model::PatchChain& chain,
                           std::vector<model::ChainVariable> variables,
                           const ChainProblemOptions& options)
    : ChainObjective(std::move(variables), to_numbers(propagated(chain), model::ChainLayout(chain)),
                     options.within),
      chain_(propagated(chain)),
      layout_(chain),
      options_(options) {
  for (const model::FamilyPatch& patch : chain_.patches) {
    const model::Surface form = model::bezier_form(patch);
    const std::pair degrees(form.degree_u, form.degree_v);
    if (!tables_.contains(degrees)) {
      tables_.try_emplace(degrees, form.degree_u, form.degree_v, options.nodes, model::Range::whole,
                          false);
    }
  }
}

model::PatchChain ChainProblem::chain_at(const Eigen::VectorXd& x) const {
  model::PatchChain chain = chain_;
  set_numbers(chain, layout_, numbers_at(x));
  propagate(chain);
  return chain;
}

// Weighted terms of one patch; adds to the adjoints of its numbers when `bar` is not null.
double ChainProblem::patch_value(const model::FamilyPatch& patch, model::FamilyPatchBar* bar) {
  const model::Kernels& kernel = model::kernels(options_.isa);
  const model::Surface form = model::bezier_form(patch);
  const model::FaceRule& rule = tables_.at({form.degree_u, form.degree_v}).rule();
  const std::vector<double> net = flat(form.net);
  if (bar == nullptr) {
    const double bending = kernel.bending(rule, net.data(), nullptr);
    bending_ += bending;
    return options_.bending * bending +
           options_.fold * kernel.fold(rule, net.data(), nullptr, options_.fold_options);
  }
  std::vector<double> net_bar(net.size(), 0.0);
  const double bending =
      kernel.bending_pullback(rule, net.data(), nullptr, options_.bending, net_bar.data(), nullptr);
  const double fold = kernel.fold_pullback(rule, net.data(), nullptr, options_.fold_options,
                                           options_.fold, net_bar.data(), nullptr);
  bending_ += bending;
  bezier_form_pullback(patch, points_of(net_bar), *bar);
  return options_.bending * bending + options_.fold * fold;
}

double ChainProblem::value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  model::PatchChain chain;
  try {
    chain = chain_at(x);
  } catch (const std::invalid_argument&) {
    if (gradient) gradient->setConstant(x.size(), std::numeric_limits<double>::quiet_NaN());
    return std::numeric_limits<double>::quiet_NaN();
  }
  double sum = 0.0;
  bending_ = 0.0;
  std::vector<model::FamilyPatchBar> bars;
  for (const model::FamilyPatch& patch : chain.patches)
    sum += patch_value(patch, gradient ? &bars.emplace_back(patch) : nullptr);
  if (gradient) *gradient = numbers_at_pullback(propagate_pullback(chain, layout_, bars));
  return sum;
}

}  // namespace bodyline::optimize
