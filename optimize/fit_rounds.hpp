#pragma once

#include <chrono>
#include <limits>
#include <string>
#include <vector>

#include "optimize/fit_options.hpp"
#include "optimize/fit_phase.hpp"

namespace bodyline::optimize {

/// A body on its way through the rounds of a fit.
class FitRounds {
 public:
  using Clock = std::chrono::steady_clock;

  /// `targets` and `options` must outlive it.
  FitRounds(const std::vector<FitTargetMaker>& targets, const FitOptions& options,
            const model::Model& start, Clock::time_point begin)
      : targets_(&targets), options_(&options), model_(start), begin_(begin) {}

  /// From the start to curves with whole patches: a warp of everything, then every curve by itself.
  void approach();
  /// Then everything with the closed body; and rounds more while a face folds.
  void refine();

  const model::Model& model() const { return model_; }
  /// That of the targets together at the end of the last phase, mm (FitPhase::misfit).
  double misfit() const { return misfit_; }
  /// Whether it did not fail and has a misfit.
  bool usable() const;
  /// Whether it comes before another one: what is not usable comes last.
  bool closer_than(const FitRounds& other) const;
  const std::vector<FitProgress>& history() const { return history_; }
  const std::vector<std::string>& folded_faces() const { return folded_faces_; }
  Status status() const { return status_; }
  /// Whether the user asked to stop.
  bool stopped() const { return options_->should_stop && options_->should_stop(); }

  /// Whether its rounds are told to FitOptions::on_progress from now on; at first they are not.
  void tell(bool tells) { tells_ = tells; }

 private:
  FitPhase phase(model::Stage stage, std::vector<std::string> vary, double bending,
                 int evaluations) const;
  /// Whether a phase is to end before its time: what fails once fails again.
  bool over() const { return failed_ || stopped(); }
  void run(FitPhase& phase, const std::string& name, int rounds, double first, double last);
  void unfold(FitPhase& phase);
  void settle(FitPhase& phase, FitRound round);
  void one_round(FitPhase& phase, const std::string& name, int index, int rounds,
                 const FitRound& round);

  const std::vector<FitTargetMaker>* targets_;
  const FitOptions* options_;
  model::Model model_;
  Clock::time_point begin_;
  std::vector<FitProgress> history_;
  std::vector<std::string> folded_faces_;
  bool tells_ = false;
  Status status_ = Status::failed;
  bool failed_ = false;  // the last round of the phase
  double misfit_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace bodyline::optimize
