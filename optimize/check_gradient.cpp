#include "optimize/check_gradient.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "optimize/scaled_problem.hpp"

namespace bodyline::optimize {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int halvings = 40;          // from one unit to 1e-12 of it
constexpr int window = 11;            // steps in three decades of halvings
constexpr double value_noise = 16;    // units in the last place that a value may be wrong by
constexpr double clear_noises = 200;  // a remainder this many noises high gives its slope to 1 %
constexpr double difference_step = 1e-3;  // of the difference quotients, in units

/// The function around the point where it is checked.
class Neighbourhood {
 public:
  Neighbourhood(Problem& problem, const Eigen::VectorXd& x)
      : problem_(problem), scaled_(problem, x) {
    x_ = scaled_.expanded(Eigen::VectorXd::Zero(scaled_.size()));
    gradient_.resize(problem.size());
    value_ = problem.value(x_, &gradient_);
    if (!std::isfinite(value_) || !gradient_.allFinite()) {
      throw std::domain_error("The function has no finite value and gradient where it is checked.");
    }
  }

  ScaledProblem& scaled() { return scaled_; }
  Problem& problem() { return problem_; }
  const Eigen::VectorXd& x() const { return x_; }
  double value() const { return value_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }

  /// |f(x + d) - f(x) - d.g| for the move to y that is made after rounding; NaN where it says
  /// nothing.
  double remainder(const Eigen::VectorXd& y) {
    const Eigen::VectorXd move = scaled_.expanded(y) - x_;
    const double moved = scaled_.value(y, nullptr);
    const double difference = std::abs(moved - value_ - move.dot(gradient_));
    const double noise = value_noise * epsilon * std::max(std::abs(value_), std::abs(moved));
    return difference > clear_noises * noise ? difference : nan;
  }

 private:
  Problem& problem_;
  ScaledProblem scaled_;
  Eigen::VectorXd x_, gradient_;
  double value_;
};

double uniform(std::mt19937_64& generator) {
  return std::ldexp(static_cast<double>(generator() >> 11), -53);
}

/// A random direction in the scaled variables with entries of size 0.5 to 1 that can be followed
/// for half a unit.
Eigen::VectorXd random_direction(const ScaledProblem& problem, std::mt19937_64& generator) {
  Eigen::VectorXd direction(problem.size());
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    const double size = 0.5 + 0.5 * uniform(generator);
    const bool up = (generator() >> 63) != 0;
    const double room = up ? problem.upper()[i] : -problem.lower()[i];
    direction[i] = (up == (room >= 0.5)) ? size : -size;
  }
  return direction;
}

/// Slope of the line through (log step, log remainder) that fits best.
double fitted_slope(const std::vector<double>& steps, const std::vector<double>& remainders) {
  const auto count = static_cast<Eigen::Index>(steps.size());
  const Eigen::ArrayXd s = Eigen::Map<const Eigen::ArrayXd>(steps.data(), count).log();
  const Eigen::ArrayXd r = Eigen::Map<const Eigen::ArrayXd>(remainders.data(), count).log();
  const Eigen::ArrayXd centred = s - s.mean();
  return (centred * (r - r.mean())).sum() / centred.square().sum();
}

TaylorTest taylor_test(Neighbourhood& place, const Eigen::VectorXd& direction) {
  std::vector<double> steps, remainders;
  for (int k = 1; k <= halvings; ++k) {
    const double step = std::ldexp(1.0, -k);
    const double remainder = place.remainder(step * direction);
    const bool full = steps.size() >= window;
    if (std::isnan(remainder) && full) break;
    if (std::isnan(remainder)) {
      steps.clear(), remainders.clear();
      continue;
    }
    steps.push_back(step);
    remainders.push_back(remainder);
  }
  if (steps.size() < window) return {steps, remainders, nan};
  // The last three decades before round-off, where higher orders weigh least.
  steps.erase(steps.begin(), steps.end() - window);
  remainders.erase(remainders.begin(), remainders.end() - window);
  return {steps, remainders, fitted_slope(steps, remainders)};
}

/// A difference quotient of fourth order: sum of weight * f(x + offset * h) / h.
struct Stencil {
  std::array<double, 5> offsets, weights;
};
constexpr Stencil central{{-2, -1, 0, 1, 2}, {1.0 / 12, -2.0 / 3, 0, 2.0 / 3, -1.0 / 12}};
constexpr Stencil forward{{0, 1, 2, 3, 4}, {-25.0 / 12, 4, -3, 4.0 / 3, -0.25}};

GradientEntry compare(Neighbourhood& place, Eigen::Index k) {
  Problem& problem = place.problem();
  const double lower = problem.lower()[k], upper = problem.upper()[k], x = place.x()[k];
  const double unit = std::min(problem.scale()[k], upper - lower);
  // A power of two, so that x + h is mostly exact.
  double h = std::exp2(std::round(std::log2(difference_step * unit)));
  const bool is_central = x - 2 * h >= lower && x + 2 * h <= upper;
  if (!is_central && x + 4 * h > upper) h = -h;
  const Stencil& stencil = is_central ? central : forward;
  Eigen::VectorXd moved = place.x();
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < stencil.offsets.size(); ++i) {
    if (stencil.weights[i] == 0) continue;
    moved[k] = x + stencil.offsets[i] * h;
    const double value = problem.value(moved, nullptr);
    sum += stencil.weights[i] * value;
    largest = std::max(largest, std::abs(value));
  }
  GradientEntry entry{k, place.gradient()[k], sum / h, 0};
  const double noise =
      value_noise * epsilon * (largest + std::abs(x * entry.analytic)) / std::abs(h);
  const double difference = std::abs(entry.analytic - entry.numeric) - noise;
  const double size = std::max(std::abs(entry.analytic), std::abs(entry.numeric));
  if (!std::isfinite(entry.numeric)) {
    entry.error = std::numeric_limits<double>::infinity();
  } else if (difference > 0) {
    entry.error = difference / size;
  }
  return entry;
}

/// The variables to compare: those that are not fixed, or a seeded choice of them.
std::vector<Eigen::Index> chosen_entries(const Problem& problem, int count,
                                         std::mt19937_64& generator) {
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (problem.lower()[i] < problem.upper()[i]) chosen.push_back(i);
  }
  const auto wanted = static_cast<std::size_t>(count);
  if (wanted == 0 || wanted >= chosen.size()) return chosen;
  for (std::size_t i = 0; i < wanted; ++i) {
    std::swap(chosen[i], chosen[i + generator() % (chosen.size() - i)]);
  }
  chosen.resize(wanted);
  return chosen;
}

void compare_entries(Neighbourhood& place, const GradientCheckOptions& options,
                     std::mt19937_64& generator, GradientReport& report) {
  for (const Eigen::Index k : chosen_entries(place.problem(), options.checked_entries, generator)) {
    report.worst.push_back(compare(place, k));
  }
  std::stable_sort(
      report.worst.begin(), report.worst.end(),
      [](const GradientEntry& a, const GradientEntry& b) { return a.error > b.error; });
  if (!report.worst.empty()) report.worst_error = report.worst.front().error;
  const auto kept = static_cast<std::size_t>(std::max(options.reported_entries, 0));
  if (report.worst.size() > kept) report.worst.resize(kept);
}

}  // namespace

GradientReport check_gradient(Problem& problem, const Eigen::VectorXd& x,
                              const GradientCheckOptions& options) {
  Neighbourhood place(problem, x);
  std::mt19937_64 generator(options.seed);
  GradientReport report;
  report.value = place.value();
  report.worst_slope = nan;
  for (int i = 0; i < options.directions; ++i) {
    const Eigen::VectorXd direction = random_direction(place.scaled(), generator);
    report.directions.push_back(taylor_test(place, direction));
    const double slope = report.directions.back().slope;
    const bool worse =
        std::isnan(report.worst_slope) || std::abs(slope - 2) > std::abs(report.worst_slope - 2);
    if (!std::isnan(slope) && worse) report.worst_slope = slope;
  }
  compare_entries(place, options, generator, report);
  return report;
}

}  // namespace bodyline::optimize
