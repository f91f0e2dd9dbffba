#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/peers.hpp"

/// What others use to measure many variants and to keep them.
namespace bodyline::bench {

/// SQLite: a new database with one table, a REAL column for each number of a row; the INSERT is
/// prepared once.
enum class SqliteWay {
  one_by_one,         ///< autocommit as it comes: each row is a transaction, safe on the disk
  one_by_one_unsafe,  ///< the same with synchronous = OFF: nothing waits for the disk
  bulk                ///< one transaction for all, safe on the disk at its end
};
BODYLINE_PEER void write_sqlite(const std::filesystem::path& path, SqliteWay way, int columns,
                                std::span<const double> rows);

/// pagmo2's batch evaluator on threads (oneTBB), of a problem with one objective. `points` has a
/// point of `dimension` numbers after the other, all within [lower, upper]; `fitness` is safe to
/// call from several threads. Returns the objectives.
BODYLINE_PEER std::vector<double> pagmo_batch(
    std::span<const double> lower, std::span<const double> upper, std::span<const double> points,
    const std::function<double(std::span<const double>)>& fitness);

}  // namespace bodyline::bench
