#include "explore/sampler_random.hpp"

#include "explore/philox.hpp"
#include "explore/random_purpose.hpp"

namespace bodyline::explore {
namespace {

class RandomSampler : public Sampler {
 public:
  RandomSampler(int dimension, std::uint64_t count, std::uint64_t seed)
      : dimension_(dimension), count_(count), random_(seed, RandomPurpose::uniform) {}

  std::uint64_t size() const override { return count_; }
  int dimension() const override { return dimension_; }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    std::size_t at = 0;
    for (int row = 0; row < count; ++row) {
      for (int k = 0; k < dimension_; k += 2) {
        const auto pair = random_.uniform(first + std::uint64_t(row), std::uint32_t(k));
        rows[at++] = pair[0];
        if (k + 1 < dimension_) rows[at++] = pair[1];
      }
    }
  }

 private:
  int dimension_;
  std::uint64_t count_;
  PlacedRandom random_;
};

}  // namespace

std::unique_ptr<Sampler> random_sampler(int dimension, std::uint64_t count, std::uint64_t seed) {
  return std::make_unique<RandomSampler>(dimension, count, seed);
}

}  // namespace bodyline::explore
