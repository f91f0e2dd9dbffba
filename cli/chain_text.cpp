#include "cli/chain_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/chain_variables.hpp"
#include "model/curve_chain_numbers.hpp"
#include "model/curve_chain_variables.hpp"
#include "model/join_measure.hpp"

namespace bodyline::cli {
namespace {

std::string join_header(std::size_t width) {
  return fmt::format("{:<{}}  {:<9}  {:>10}  {:>8}  {:>12}  {:>12}\n", "join", width, "direction",
                     "continuity", "gap mm", "turn deg", "jump 1/mm");
}

std::string join_line(const std::string& name, std::size_t width, const std::string& direction,
                      int continuity, const model::JoinMeasure& measure) {
  return fmt::format("{:<{}}  {:<9}  {:>10}  {:>8.2g}  {:>12.3g}  {:>12.3g}\n", name, width,
                     direction, fmt::format("G{}", continuity), measure.gap_mm,
                     measure.direction_deg, measure.curvature_jump_per_mm);
}

std::string variables_text(std::vector<model::ChainVariable> variables,
                           const Eigen::VectorXd& numbers) {
  std::erase_if(variables, [](const auto& v) { return v.kind == model::ChainKind::point; });
  std::size_t width = 4;
  for (const auto& variable : variables) width = std::max(width, variable.name.size());
  std::string text = fmt::format("{:<{}}  {:>12}  {:>8}  {:>8}  {:>7}  {}\n", "free", width,
                                 "value", "lower", "upper", "numbers", "control points");
  for (const auto& variable : variables) {
    text += fmt::format("{:<{}}  {:>12.6g}  {:>8.3g}  {:>8.3g}  {:>7}  {}\n", variable.name, width,
                        numbers[variable.members.front()], variable.lower, variable.upper,
                        variable.members.size(),
                        variable.points_stay ? "may stay" : "are computed again");
  }
  return text;
}

}  // namespace

std::string chain_joins_text(const model::PatchChain& chain) {
  std::vector<std::string> names;
  std::size_t width = 4;
  for (std::size_t k = 0; k < chain.joins.size(); ++k) {
    names.push_back(chain.patches[k].name + " - " + chain.patches[k + 1].name);
    width = std::max(width, names.back().size());
  }
  std::string text = join_header(width);
  for (std::size_t k = 0; k < chain.joins.size(); ++k) {
    const model::PatchJoin& join = chain.joins[k];
    text += join_line(names[k], width, model::join_direction_name(join.direction), join.continuity,
                      model::measure_join(chain.patches[k], join.direction, chain.patches[k + 1]));
  }
  return text;
}

std::string chain_joins_text(const model::CurveChain& chain) {
  const std::size_t count = chain.curves.size();
  std::vector<std::string> names;
  std::size_t width = 4;
  for (std::size_t k = 0; k < chain.joins.size(); ++k) {
    names.push_back(chain.curves[k].name + " - " + chain.curves[(k + 1) % count].name);
    width = std::max(width, names.back().size());
  }
  std::string text = join_header(width);
  for (std::size_t k = 0; k < chain.joins.size(); ++k)
    text += join_line(names[k], width, "", chain.joins[k].continuity,
                      model::measure_join(chain, int(k)));
  return text;
}

std::string chain_variables_text(const model::PatchChain& chain) {
  return variables_text(model::chain_variables(chain),
                        model::to_numbers(chain, model::ChainLayout(chain)));
}

std::string chain_variables_text(const model::CurveChain& chain) {
  return variables_text(model::chain_variables(chain),
                        model::to_numbers(chain, model::CurveChainLayout(chain)));
}

std::string chain_tuning_text(const optimize::ChainTuning& tuning, const std::string& measure) {
  return fmt::format("{}\n{} {:.6g} before, {:.6g} after; {} variables, {} evaluations, {:.2f} s\n",
                     optimize::status_words(tuning.status), measure, tuning.start_measure,
                     tuning.end_measure, tuning.variables.size(), tuning.evaluations,
                     tuning.seconds);
}

}  // namespace bodyline::cli
