#include "explore/sampler_halton.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "explore/philox.hpp"
#include "explore/random_purpose.hpp"

namespace bodyline::explore {
namespace {

std::vector<int> first_primes(int count) {
  std::vector<int> primes;
  for (int n = 2; int(primes.size()) < count; ++n) {
    bool prime = true;
    for (const int p : primes) {
      if (p * p > n) break;
      prime = prime && n % p != 0;
    }
    if (prime) primes.push_back(n);
  }
  return primes;
}

// Digits of a fraction in a base, each with a permutation of its own.
class Digits {
 public:
  Digits(int base, const PlacedRandom* random, std::uint32_t dimension)
      : base_(base), places_(int(std::ceil(53.0 * std::log(2.0) / std::log(base)))) {
    for (int place = 0; place < places_; ++place) {
      permutations_.push_back(std::vector<int>(std::size_t(base)));
      std::iota(permutations_.back().begin(), permutations_.back().end(), 0);
      if (random != nullptr) shuffle(*random, dimension, place);
    }
    // rest_[p]: what the digits from place p on add where the index has none but zeros.
    rest_.assign(std::size_t(places_) + 1, 0.0);
    for (int place = places_ - 1; place >= 0; --place)
      rest_[place] = (rest_[place + 1] + permutations_[place][0]) / base;
  }

  double fraction(std::uint64_t index) const {
    double sum = 0.0, unit = 1.0;
    int place = 0;
    for (; index != 0 && place < places_; index /= std::uint64_t(base_), ++place) {
      unit /= base_;
      sum += unit * permutations_[place][index % std::uint64_t(base_)];
    }
    return std::min(sum + unit * rest_[place], largest_);
  }

 private:
  void shuffle(const PlacedRandom& random, std::uint32_t dimension, int place) {
    std::vector<int>& digits = permutations_[place];
    for (int k = base_ - 1; k > 0; --k) {
      const double draw =
          random.uniform(std::uint64_t(place) << 32 | std::uint64_t(k), dimension)[0];
      std::swap(digits[k], digits[std::size_t(draw * (k + 1))]);
    }
  }

  static constexpr double largest_ = 1.0 - 0x1p-53;
  int base_, places_;
  std::vector<std::vector<int>> permutations_;
  std::vector<double> rest_;
};

class HaltonSampler : public Sampler {
 public:
  HaltonSampler(int dimension, std::uint64_t count, bool scrambled, std::uint64_t seed)
      : count_(count) {
    const PlacedRandom random(seed, RandomPurpose::halton);
    const std::vector<int> primes = first_primes(dimension);
    for (int k = 0; k < dimension; ++k)
      digits_.emplace_back(primes[k], scrambled ? &random : nullptr, std::uint32_t(k));
  }

  std::uint64_t size() const override { return count_; }
  int dimension() const override { return int(digits_.size()); }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    std::size_t at = 0;
    for (int row = 0; row < count; ++row) {
      for (const Digits& digits : digits_) rows[at++] = digits.fraction(first + std::uint64_t(row));
    }
  }

 private:
  std::uint64_t count_;
  std::vector<Digits> digits_;
};

}  // namespace

std::unique_ptr<Sampler> halton_sampler(int dimension, std::uint64_t count, bool scrambled,
                                        std::uint64_t seed) {
  if (dimension > most_halton_dimensions) {
    throw std::invalid_argument("a Halton sequence has at most " +
                                std::to_string(most_halton_dimensions) + " dimensions");
  }
  return std::make_unique<HaltonSampler>(dimension, count, scrambled, seed);
}

}  // namespace bodyline::explore
