#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "model/kernels.hpp"

namespace bodyline::model::isa {
namespace baseline {
void reciprocal_sqrts(const double* x, double* out, int count);
}
#if defined(BODYLINE_X86_KERNELS)
namespace avx2 {
void reciprocal_sqrts(const double* x, double* out, int count);
}
namespace avx512 {
void reciprocal_sqrts(const double* x, double* out, int count);
}
#endif
}  // namespace bodyline::model::isa

namespace bodyline::test {
namespace {

using Function = void (*)(const double*, double*, int);

std::vector<Function> implementations() {
  std::vector<Function> all = {model::isa::baseline::reciprocal_sqrts};
#if defined(BODYLINE_X86_KERNELS)
  if (model::isa_available(model::Isa::avx2)) all.push_back(model::isa::avx2::reciprocal_sqrts);
  if (model::isa_available(model::Isa::avx512)) all.push_back(model::isa::avx512::reciprocal_sqrts);
#endif
  return all;
}

/// Largest error over `x` in units in the last place of the result.
double largest_error(Function function, const std::vector<double>& x) {
  std::vector<double> got(x.size());
  function(x.data(), got.data(), static_cast<int>(x.size()));
  double most = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const long double exact = 1.0L / std::sqrt(static_cast<long double>(x[k]));
    const double rounded = static_cast<double>(exact);
    const double unit = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
    most = std::max(most, static_cast<double>(std::abs(got[k] - exact)) / unit);
  }
  return most;
}

TEST(ReciprocalSqrt, IsWithinTwoUnitsInTheLastPlace) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(1.0, 4.0);
  std::vector<double> x(1 << 20);
  for (double& value : x) value = mantissa(random);
  for (const Function function : implementations()) EXPECT_LT(largest_error(function, x), 2.0);
}

TEST(ReciprocalSqrt, IsAsGoodOverTheWholeRangeOfExponents) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> exponent(-1000.0, 1000.0);
  std::vector<double> x(1 << 18);
  for (double& value : x) value = std::exp2(exponent(random));
  for (const Function function : implementations()) EXPECT_LT(largest_error(function, x), 2.0);
}

TEST(ReciprocalSqrt, IsExactForPowersOfFour) {
  std::vector<double> x;
  for (int k = -200; k < 200; ++k) x.push_back(std::ldexp(1.0, 2 * k));
  for (const Function function : implementations()) EXPECT_EQ(largest_error(function, x), 0.0);
}

}  // namespace
}  // namespace bodyline::test
