#include "explore/sampler_grid.hpp"

#include <algorithm>
#include <stdexcept>

namespace bodyline::explore {
namespace {

constexpr std::uint64_t most_points = 1'000'000'000'000;

class FactorialSampler : public Sampler {
 public:
  explicit FactorialSampler(Levels levels) : levels_(std::move(levels)) {
    for (const auto& values : levels_) {
      if (size_ > most_points / values.size()) {
        throw std::invalid_argument(
            "all combinations are more than 10^12; take fewer variables or levels");
      }
      size_ *= values.size();
    }
  }

  std::uint64_t size() const override { return size_; }
  int dimension() const override { return int(levels_.size()); }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    for (int row = 0; row < count; ++row) {
      std::uint64_t rest = first + std::uint64_t(row);
      for (std::size_t k = levels_.size(); k-- > 0;) {
        rows[std::size_t(row) * levels_.size() + k] = levels_[k][rest % levels_[k].size()];
        rest /= levels_[k].size();
      }
    }
  }

 private:
  Levels levels_;
  std::uint64_t size_ = 1;
};

class OneAtATimeSampler : public Sampler {
 public:
  OneAtATimeSampler(std::vector<double> base, const Levels& levels) : base_(std::move(base)) {
    for (std::size_t k = 0; k < levels.size(); ++k) {
      for (const double level : levels[k]) moves_.push_back({k, level});
    }
  }

  std::uint64_t size() const override { return moves_.size() + 1; }
  int dimension() const override { return int(base_.size()); }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    for (int row = 0; row < count; ++row) {
      const std::span<double> point = rows.subspan(std::size_t(row) * base_.size(), base_.size());
      std::copy(base_.begin(), base_.end(), point.begin());
      const std::uint64_t index = first + std::uint64_t(row);
      if (index > 0) point[moves_[index - 1].dimension] = moves_[index - 1].level;
    }
  }

 private:
  struct Move {
    std::size_t dimension;
    double level;
  };
  std::vector<double> base_;
  std::vector<Move> moves_;
};

}  // namespace

std::unique_ptr<Sampler> factorial_sampler(Levels levels) {
  return std::make_unique<FactorialSampler>(std::move(levels));
}

std::unique_ptr<Sampler> one_at_a_time_sampler(std::vector<double> base, Levels levels) {
  return std::make_unique<OneAtATimeSampler>(std::move(base), levels);
}

}  // namespace bodyline::explore
