#include "explore/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "explore/philox.hpp"
#include "explore/random_purpose.hpp"
#include "explore/sampler_sensitivity.hpp"

namespace bodyline::explore {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int resamples = 200;
constexpr double normal_95 = 1.959963984540054;  // of the normal distribution
constexpr std::uint64_t seed = 1;

using Groups = std::vector<std::size_t>;
// Numbers of a choice of groups.
using Statistic = std::function<std::vector<double>(const Groups&)>;

// The statistic of all groups, with the spread that it has over resampled ones.
std::vector<Estimate> estimated(const Groups& groups, const Statistic& statistic) {
  const std::vector<double> values = statistic(groups);
  std::vector<double> sum(values.size(), 0.0), squares(values.size(), 0.0);
  const PlacedRandom random(seed, RandomPurpose::resampling);
  Groups drawn(groups.size());
  for (int n = 0; n < resamples; ++n) {
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const double draw = random.uniform(std::uint64_t(k), std::uint32_t(n))[0];
      drawn[k] = groups[std::size_t(draw * double(groups.size()))];
    }
    const std::vector<double> again = statistic(drawn);
    for (std::size_t k = 0; k < values.size(); ++k) {
      sum[k] += again[k];
      squares[k] += again[k] * again[k];
    }
  }
  std::vector<Estimate> estimates;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double mean = sum[k] / resamples;
    const double variance = std::max(0.0, squares[k] / resamples - mean * mean);
    estimates.push_back({values[k], normal_95 * std::sqrt(variance)});
  }
  return estimates;
}

// The groups of `length` results that are all finite.
Groups finite_groups(std::span<const double> results, std::size_t length) {
  Groups groups;
  for (std::size_t g = 0; g < results.size() / length; ++g) {
    const auto group = results.subspan(g * length, length);
    if (std::all_of(group.begin(), group.end(), [](double x) { return std::isfinite(x); }))
      groups.push_back(g);
  }
  return groups;
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? nan : sum / double(values.size());
}

// The results of a Saltelli design by what they are of.
struct SaltelliResults {
  std::span<const double> results;
  std::size_t dimension, length;
  bool second_order;

  double a(std::size_t g) const { return results[g * length]; }
  double b(std::size_t g) const { return results[(g + 1) * length - 1]; }
  double ab(std::size_t g, std::size_t k) const { return results[g * length + 1 + k]; }
  double ba(std::size_t g, std::size_t k) const { return results[g * length + 1 + dimension + k]; }
};

// Mean and variance of A and B together.
std::pair<double, double> moments(const SaltelliResults& r, const Groups& groups) {
  double sum = 0.0, squares = 0.0;
  for (const std::size_t g : groups) sum += r.a(g) + r.b(g);
  const double count = 2.0 * double(groups.size()), mean = sum / count;
  for (const std::size_t g : groups)
    squares += (r.a(g) - mean) * (r.a(g) - mean) + (r.b(g) - mean) * (r.b(g) - mean);
  return {mean, squares / count};
}

// First, total and second indices one after the other.
std::vector<double> indices_of(const SaltelliResults& r, const Groups& groups) {
  const std::size_t d = r.dimension;
  const auto [mean, variance] = moments(r, groups);
  const double scale = 1.0 / (double(groups.size()) * variance);
  std::vector<double> indices(r.second_order ? d * (d + 2) : 2 * d, 0.0);
  for (std::size_t k = 0; k < d; ++k) {
    double first = 0.0, total = 0.0;
    for (const std::size_t g : groups) {
      // Results are taken from their mean, which makes the products small.
      first += (r.b(g) - mean) * (r.ab(g, k) - r.a(g));
      total += 0.5 * (r.a(g) - r.ab(g, k)) * (r.a(g) - r.ab(g, k));
    }
    indices[k] = first * scale;
    indices[d + k] = total * scale;
  }
  if (!r.second_order) return indices;
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = i + 1; j < d; ++j) {
      double both = 0.0;
      for (const std::size_t g : groups)
        both += (r.ba(g, i) - mean) * (r.ab(g, j) - mean) - (r.a(g) - mean) * (r.b(g) - mean);
      indices[2 * d + i * d + j] = both * scale - indices[i] - indices[j];
    }
  }
  return indices;
}

}  // namespace

MorrisResult morris_effects(std::span<const double> points, std::span<const double> results,
                            int dimension) {
  const std::size_t d = std::size_t(dimension), length = std::size_t(morris_rows(dimension));
  const Groups groups = finite_groups(results, length);
  // Of each coordinate the effects in all trajectories.
  std::vector<std::vector<double>> effects(d);
  for (const std::size_t g : groups) {
    for (std::size_t row = g * length; row + 1 < (g + 1) * length; ++row) {
      for (std::size_t k = 0; k < d; ++k) {
        const double step = points[(row + 1) * d + k] - points[row * d + k];
        if (step != 0.0) effects[k].push_back((results[row + 1] - results[row]) / step);
      }
    }
  }
  MorrisResult result;
  result.used = groups.size();
  result.all = results.size() / length;
  for (const std::vector<double>& of_one : effects) {
    MorrisEffect effect;
    effect.mu = mean_of(of_one);
    double squares = 0.0;
    for (const double e : of_one) squares += (e - effect.mu) * (e - effect.mu);
    effect.sigma = of_one.size() > 1 ? std::sqrt(squares / double(of_one.size() - 1)) : nan;
    Groups all(of_one.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    effect.mu_star = estimated(all, [&](const Groups& chosen) {
                       double sum = 0.0;
                       for (const std::size_t k : chosen) sum += std::abs(of_one[k]);
                       return std::vector<double>{sum / double(chosen.size())};
                     }).front();
    result.effects.push_back(effect);
  }
  return result;
}

SobolIndices sobol_indices(std::span<const double> results, int dimension, bool second_order) {
  const SaltelliResults r{results, std::size_t(dimension),
                          std::size_t(saltelli_rows(dimension, second_order)), second_order};
  const Groups groups = finite_groups(results, r.length);
  const std::vector<Estimate> all =
      estimated(groups, [&](const Groups& chosen) { return indices_of(r, chosen); });
  SobolIndices indices;
  indices.used = groups.size();
  indices.all = results.size() / r.length;
  const auto at = [&](std::size_t k) { return all.begin() + std::ptrdiff_t(k); };
  indices.first.assign(at(0), at(r.dimension));
  indices.total.assign(at(r.dimension), at(2 * r.dimension));
  indices.second.assign(at(2 * r.dimension), all.end());
  return indices;
}

}  // namespace bodyline::explore
