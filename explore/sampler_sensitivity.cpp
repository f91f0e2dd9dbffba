#include "explore/sampler_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "explore/philox.hpp"
#include "explore/random_purpose.hpp"
#include "explore/sampler_sobol.hpp"

namespace bodyline::explore {
namespace {

// One trajectory: where each coordinate starts and ends, and in which order they move.
struct Trajectory {
  std::vector<double> from, to;
  std::vector<int> step;  // after how many steps each coordinate has moved
};

class MorrisSampler : public Sampler {
 public:
  MorrisSampler(int dimension, int trajectories, int levels, std::uint64_t seed)
      : dimension_(dimension),
        trajectories_(trajectories),
        levels_(levels),
        random_(seed, RandomPurpose::morris) {}

  std::uint64_t size() const override {
    return std::uint64_t(trajectories_) * std::uint64_t(morris_rows(dimension_));
  }
  int dimension() const override { return dimension_; }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    const std::uint64_t length = std::uint64_t(morris_rows(dimension_));
    Trajectory trajectory;
    for (int row = 0; row < count; ++row) {
      const std::uint64_t index = first + std::uint64_t(row);
      if (row == 0 || index % length == 0) trajectory = make(index / length);
      for (int k = 0; k < dimension_; ++k) {
        const bool moved = trajectory.step[k] <= int(index % length);
        rows[std::size_t(row) * dimension_ + k] = moved ? trajectory.to[k] : trajectory.from[k];
      }
    }
  }

 private:
  Trajectory make(std::uint64_t index) const {
    const double step = levels_ / (2.0 * (levels_ - 1));
    Trajectory trajectory;
    std::vector<int> order(std::size_t(dimension_), 0);
    std::iota(order.begin(), order.end(), 0);
    for (int k = dimension_ - 1; k > 0; --k) {
      const double draw = random_.uniform(index, std::uint32_t(2 * k))[0];
      std::swap(order[k], order[std::size_t(draw * (k + 1))]);
    }
    trajectory.step.resize(order.size());
    for (int n = 0; n < dimension_; ++n) trajectory.step[order[n]] = n + 1;
    for (int k = 0; k < dimension_; ++k) {
      const auto draw = random_.uniform(index, std::uint32_t(2 * k + 1));
      const double low = std::floor(draw[0] * (levels_ / 2)) / (levels_ - 1);
      const bool rises = draw[1] < 0.5;
      trajectory.from.push_back(rises ? low : low + step);
      trajectory.to.push_back(rises ? low + step : low);
    }
    return trajectory;
  }

  int dimension_, trajectories_, levels_;
  PlacedRandom random_;
};

class SaltelliSampler : public Sampler {
 public:
  SaltelliSampler(int dimension, std::uint64_t count, bool second_order, bool scrambled,
                  std::uint64_t seed)
      : dimension_(dimension),
        rows_(saltelli_rows(dimension, second_order)),
        pairs_(sobol_sampler(2 * dimension, count, scrambled, seed)) {}

  std::uint64_t size() const override { return pairs_->size() * std::uint64_t(rows_); }
  int dimension() const override { return dimension_; }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    const std::size_t d = std::size_t(dimension_);
    std::vector<double> pair(2 * d);
    for (int row = 0; row < count; ++row) {
      const std::uint64_t index = first + std::uint64_t(row);
      const std::size_t place = index % std::uint64_t(rows_);
      if (row == 0 || place == 0) pairs_->points(index / std::uint64_t(rows_), 1, pair);
      const std::span<const double> a(pair.data(), d), b(pair.data() + d, d);
      const bool mostly_a = place <= d;
      const std::span<double> point = rows.subspan(std::size_t(row) * d, d);
      std::copy_n((mostly_a ? a : b).begin(), d, point.begin());
      if (place == 0 || place + 1 == std::size_t(rows_)) continue;
      const std::size_t changed = (place - 1) % d;
      point[changed] = (mostly_a ? b : a)[changed];
    }
  }

 private:
  int dimension_, rows_;
  std::unique_ptr<Sampler> pairs_;
};

}  // namespace

std::unique_ptr<Sampler> morris_sampler(int dimension, int trajectories, int levels,
                                        std::uint64_t seed) {
  return std::make_unique<MorrisSampler>(dimension, trajectories, levels, seed);
}

std::unique_ptr<Sampler> saltelli_sampler(int dimension, std::uint64_t count, bool second_order,
                                          bool scrambled, std::uint64_t seed) {
  return std::make_unique<SaltelliSampler>(dimension, count, second_order, scrambled, seed);
}

}  // namespace bodyline::explore
