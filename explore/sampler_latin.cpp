#include "explore/sampler_latin.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "explore/philox.hpp"
#include "explore/placed_permutation.hpp"
#include "explore/random_purpose.hpp"

namespace bodyline::explore {
namespace {

// In (0, 1) and so far from both that adding a stratum's number never rounds into the next one.
double place_in_stratum(std::uint64_t bits) { return (double(bits >> 44) + 0.5) * 0x1p-20; }

class LatinSampler : public Sampler {
 public:
  LatinSampler(int dimension, std::uint64_t count, std::uint64_t seed)
      : count_(count), place_(seed, RandomPurpose::latin_place) {
    const PlacedRandom order(seed, RandomPurpose::latin_order);
    for (int k = 0; k < dimension; ++k)
      strata_.emplace_back(count, order.bits(0, std::uint32_t(k))[0]);
  }

  std::uint64_t size() const override { return count_; }
  int dimension() const override { return int(strata_.size()); }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    std::size_t at = 0;
    for (int row = 0; row < count; ++row) {
      const std::uint64_t index = first + std::uint64_t(row);
      for (std::size_t k = 0; k < strata_.size(); ++k) {
        const double place = place_in_stratum(place_.bits(index, std::uint32_t(k))[0]);
        rows[at++] = (double(strata_[k](index)) + place) / double(count_);
      }
    }
  }

 private:
  std::uint64_t count_;
  PlacedRandom place_;
  std::vector<PlacedPermutation> strata_;
};

// A table of points whose distances are kept up while coordinates are exchanged.
class Exchanger {
 public:
  Exchanger(int dimension, std::vector<double> points)
      : dimension_(dimension),
        count_(points.size() / std::size_t(dimension)),
        x_(std::move(points)),
        squared_(count_ * count_, 0.0) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < count_; ++j) {
        for (int k = 0; k < dimension_; ++k) {
          const double d = at(i, k) - at(j, k);
          squared_[i * count_ + j] += d * d;
        }
      }
    }
  }

  // Exchanges coordinate k of two points when that lowers the sum.
  void try_exchange(std::size_t a, std::size_t b, int k) {
    if (a == b) return;
    double change = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (i == a || i == b) continue;
      const double moved = exchange_change(i, a, b, k);
      change += penalty(squared_[i * count_ + a] + moved) - penalty(squared_[i * count_ + a]) +
                penalty(squared_[i * count_ + b] - moved) - penalty(squared_[i * count_ + b]);
    }
    if (change >= 0.0) return;
    for (std::size_t i = 0; i < count_; ++i) {
      if (i == a || i == b) continue;
      const double moved = exchange_change(i, a, b, k);
      squared_[a * count_ + i] = squared_[i * count_ + a] += moved;
      squared_[b * count_ + i] = squared_[i * count_ + b] -= moved;
    }
    std::swap(x_[a * std::size_t(dimension_) + std::size_t(k)],
              x_[b * std::size_t(dimension_) + std::size_t(k)]);
  }

  std::vector<double> points() && { return std::move(x_); }

 private:
  double at(std::size_t i, int k) const { return x_[i * std::size_t(dimension_) + std::size_t(k)]; }
  static double penalty(double squared) {
    const double fifth = squared * squared * std::sqrt(squared);
    return 1.0 / (fifth * fifth * fifth);
  }
  // What is added to the squared distance of i from a, and taken from that of b.
  double exchange_change(std::size_t i, std::size_t a, std::size_t b, int k) const {
    const double from_a = at(i, k) - at(a, k), from_b = at(i, k) - at(b, k);
    return from_b * from_b - from_a * from_a;
  }

  int dimension_;
  std::size_t count_;
  std::vector<double> x_;
  std::vector<double> squared_;
};

std::vector<double> improved(std::vector<double> points, int dimension, std::uint64_t seed) {
  constexpr std::uint64_t exchanges_per_point = 100;
  const std::uint64_t count = points.size() / std::uint64_t(dimension);
  const PlacedRandom random(seed, RandomPurpose::latin_exchange);
  Exchanger exchanger(dimension, std::move(points));
  for (std::uint64_t n = 0; n < exchanges_per_point * count; ++n) {
    const auto pair = random.uniform(n, 0), which = random.uniform(n, 1);
    exchanger.try_exchange(std::size_t(pair[0] * double(count)),
                           std::size_t(pair[1] * double(count)), int(which[0] * dimension));
  }
  return std::move(exchanger).points();
}

// Points that are kept in memory.
class TableSampler : public Sampler {
 public:
  TableSampler(int dimension, std::vector<double> points)
      : dimension_(dimension), points_(std::move(points)) {}

  std::uint64_t size() const override { return points_.size() / std::uint64_t(dimension_); }
  int dimension() const override { return dimension_; }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    const auto begin = points_.begin() + std::ptrdiff_t(first) * dimension_;
    std::copy(begin, begin + std::ptrdiff_t(count) * dimension_, rows.begin());
  }

 private:
  int dimension_;
  std::vector<double> points_;
};

}  // namespace

std::unique_ptr<Sampler> latin_sampler(int dimension, std::uint64_t count, std::uint64_t seed) {
  return std::make_unique<LatinSampler>(dimension, count, seed);
}

void check_latin_maximin(std::uint64_t count) {
  if (count <= most_maximin_points) return;
  throw std::invalid_argument("a maximin design has at most " +
                              std::to_string(most_maximin_points) + " points");
}

std::unique_ptr<Sampler> latin_maximin_sampler(int dimension, std::uint64_t count,
                                               std::uint64_t seed) {
  check_latin_maximin(count);
  std::vector<double> points(std::size_t(count) * std::size_t(dimension));
  LatinSampler(dimension, count, seed).points(0, int(count), points);
  if (count > 2) points = improved(std::move(points), dimension, seed);
  return std::make_unique<TableSampler>(dimension, std::move(points));
}

}  // namespace bodyline::explore
