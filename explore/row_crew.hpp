#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>

#include "explore/block_codec.hpp"
#include "explore/variant_plan.hpp"
#include "explore/variant_rows.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// Threads of one process that measure while their caller does something else. For one caller.
class RowCrew {
 public:
  /// `source` must outlive it.
  RowCrew(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
          const StoreLayout& layout, int threads);
  ~RowCrew();

  int threads() const;
  /// Asks for variants first to first + count - 1; returns at once.
  void measure(std::uint64_t first, int count);
  /// Rows that are measured, in any order; waits for them as long as it is told. Throws what
  /// measuring threw.
  std::shared_ptr<VariantRows> collect(std::chrono::microseconds wait);
  /// Asks for a block as it stands in the file.
  std::future<std::shared_ptr<EncodedBlock>> encode(std::shared_ptr<VariantRows> block);
  /// Forgets all that it was asked to measure and has not begun. The destructor does so too.
  void drop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
