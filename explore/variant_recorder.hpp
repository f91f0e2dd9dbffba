#pragma once

#include <memory>
#include <span>

#include "explore/run_study.hpp"
#include "explore/store_reader.hpp"

namespace bodyline::explore {

/// Measures the variants that an optimizer asks for, on several threads, and appends them to a
/// store in the order of asking. Rows that the store had already are taken from there: a run that
/// goes on asks for the same variants again and gets the same answers.
class VariantRecorder {
 public:
  /// `begun` reads the store as it was before this run, at whose end `store` writes on.
  VariantRecorder(std::shared_ptr<const VariantPlan> plan, StoreWriter& store,
                  const StoreReader& begun, std::uint64_t planned, const RunOptions& options);
  ~VariantRecorder();

  /// How many of the next rows the store has.
  std::uint64_t known_rows() const;
  /// The next rows, which the store has.
  VariantRows take_known(int count);
  /// The next rows, of variants with these values, one value per column each. Throws StoreError
  /// when the store has others there.
  VariantRows record(std::span<const double> values);

  const VariantPlan& plan() const;
  const RunOptions& options() const;
  bool should_stop() const;
  /// Shown with the progress: "generation 3 of 20".
  void set_note(const std::string& note);
  void count_evaluations(std::uint64_t evaluations);

  /// What was done so far; reports it.
  RunProgress progress();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
