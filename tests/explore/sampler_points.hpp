#pragma once

#include <cstdint>
#include <vector>

#include "explore/sampler.hpp"

namespace bodyline::testing {

/// All points of a sampler, row by row.
inline std::vector<double> all_points(const explore::Sampler& sampler) {
  std::vector<double> rows(sampler.size() * std::uint64_t(sampler.dimension()));
  sampler.points(0, int(sampler.size()), rows);
  return rows;
}

/// Coordinate k of a row of so many.
inline double coordinate(const std::vector<double>& rows, int dimension, std::size_t row, int k) {
  return rows[row * std::size_t(dimension) + std::size_t(k)];
}

/// How many points lie in each of `strata` equal parts of coordinate k.
inline std::vector<int> counts(const std::vector<double>& rows, int dimension, int k, int strata) {
  std::vector<int> count(std::size_t(strata), 0);
  for (std::size_t row = 0; row * std::size_t(dimension) < rows.size(); ++row)
    ++count[std::size_t(coordinate(rows, dimension, row, k) * strata)];
  return count;
}

}  // namespace bodyline::testing
