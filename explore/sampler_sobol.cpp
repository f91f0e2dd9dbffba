#include "explore/sampler_sobol.hpp"

#include <bit>
#include <boost/random/sobol.hpp>
#include <stdexcept>

#include "explore/philox.hpp"
#include "explore/random_purpose.hpp"

namespace bodyline::explore {
namespace {

constexpr int bits = 32;

std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
  x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
  x = (x >> 4 & 0x0F0F0F0Fu) | (x & 0x0F0F0F0Fu) << 4;
  return __builtin_bswap32(x);
}

class SobolSampler : public Sampler {
 public:
  SobolSampler(int dimension, std::uint64_t count, bool scrambled, std::uint64_t seed)
      : dimension_(dimension), count_(count), directions_(sobol_directions(dimension)) {
    if (!scrambled) return;
    const PlacedRandom random(seed, RandomPurpose::sobol);
    for (int k = 0; k < dimension; ++k)
      seeds_.push_back(std::uint32_t(random.bits(0, std::uint32_t(k))[0]));
  }

  std::uint64_t size() const override { return count_; }
  int dimension() const override { return dimension_; }

  void points(std::uint64_t first, int count, std::span<double> rows) const override {
    std::vector<std::uint32_t> x(std::size_t(dimension_), 0);
    for (std::uint64_t gray = first ^ (first >> 1); gray != 0; gray &= gray - 1)
      flip(std::countr_zero(gray), x);
    for (int row = 0; row < count; ++row) {
      write(x, rows.subspan(std::size_t(row) * dimension_, dimension_));
      // The next Gray code differs in the bit that is the lowest one of the next index.
      const int changed = std::countr_zero(first + std::uint64_t(row) + 1);
      if (changed < bits) flip(changed, x);
    }
  }

 private:
  void flip(int bit, std::vector<std::uint32_t>& x) const {
    const std::uint32_t* directions = &directions_[std::size_t(bit) * dimension_];
    for (int k = 0; k < dimension_; ++k) x[k] ^= directions[k];
  }

  void write(const std::vector<std::uint32_t>& x, std::span<double> row) const {
    for (int k = 0; k < dimension_; ++k)
      row[k] = 0x1p-32 * (seeds_.empty() ? x[k] : nested_scramble(x[k], seeds_[k]));
  }

  int dimension_;
  std::uint64_t count_;
  std::vector<std::uint32_t> directions_;  // [bit][dimension]
  std::vector<std::uint32_t> seeds_;       // none when not scrambled
};

}  // namespace

std::vector<std::uint32_t> sobol_directions(int dimension) {
  boost::random::sobol_engine<std::uint32_t, bits> engine{std::size_t(dimension)};
  std::vector<std::uint32_t> directions;
  for (int bit = 0; bit < bits; ++bit) {
    // The engine leaves out the origin. Point 2^bit has the Gray code of bits `bit` and `bit - 1`.
    engine.seed((std::uint32_t(1) << bit) - 1);
    for (int k = 0; k < dimension; ++k) {
      const std::uint32_t before =
          bit > 0 ? directions[directions.size() - std::size_t(dimension)] : 0;
      directions.push_back(engine() ^ before);
    }
  }
  return directions;
}

std::uint32_t nested_scramble(std::uint32_t x, std::uint32_t seed) {
  x = reversed_bits(x);
  x += seed;
  x ^= x * 0x6C50B47Cu;
  x ^= x * 0xB82F1E52u;
  x ^= x * 0xC7AFE638u;
  x ^= x * 0x8D22F6E6u;
  return reversed_bits(x);
}

std::unique_ptr<Sampler> sobol_sampler(int dimension, std::uint64_t count, bool scrambled,
                                       std::uint64_t seed) {
  if (count > most_sobol_points)
    throw std::invalid_argument("a Sobol sequence has at most 2^32 points");
  if (dimension > most_sobol_dimensions) {
    throw std::invalid_argument("a Sobol sequence has at most " +
                                std::to_string(most_sobol_dimensions) + " dimensions");
  }
  return std::make_unique<SobolSampler>(dimension, count, scrambled, seed);
}

}  // namespace bodyline::explore
