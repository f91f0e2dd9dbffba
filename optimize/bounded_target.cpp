#include "optimize/bounded_target.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::optimize {
namespace {

// Bounds that cannot be held must not outgrow everything else.
constexpr double largest_shift = 100.0;

}  // namespace

void BoundedTarget::match(const double* nets, const FitRound&) {
  std::vector<NetRow> rows = measure(nets);
  shifts_.resize(rows.size(), 0.0);
  largest_excess_ = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double value = rows[k].at(nets);
    largest_excess_ = std::max(largest_excess_, std::abs(rows[k].excess(value)));
    shifts_[k] = std::clamp(rows[k].excess(value + shifts_[k]), -largest_shift, largest_shift);
    rows[k].offset += shifts_[k];
  }
  term_->set(std::move(rows));
}

}  // namespace bodyline::optimize
