#include "optimize/bounded_target.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::optimize {
namespace {

// Bounds that cannot be held must not outgrow everything else.
constexpr double largest_shift = 100.0;

}  // namespace

void BoundedTarget::match(const double* nets, const FitRound&) {
  rows_ = measure(nets);
  shifts_.resize(rows_.size(), 0.0);
  values_.clear();
  excess_ = 0.0;
  for (const NetRow& row : rows_) {
    values_.push_back(row.at(nets));
    const double excess = std::abs(row.excess(values_.back()));
    if (!(excess <= excess_) && !std::isnan(excess_)) excess_ = excess;  // NaN stays
  }
  shift_rows();
}

void BoundedTarget::advance() {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const double excess = rows_[k].excess(values_[k] + shifts_[k]);
    if (std::isfinite(excess)) shifts_[k] = std::clamp(excess, -largest_shift, largest_shift);
  }
  shift_rows();
}

void BoundedTarget::shift_rows() {
  std::vector<NetRow> shifted = rows_;
  for (std::size_t k = 0; k < shifted.size(); ++k) shifted[k].offset += shifts_[k];
  term_->set(std::move(shifted));
}

}  // namespace bodyline::optimize
