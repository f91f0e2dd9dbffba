#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "optimize/fit_phase.hpp"
#include "optimize/fit_scan.hpp"

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
  /// That of the targets together at the end of the last phase, mm (fit_target.hpp).
  double misfit() const { return misfit_; }
  const std::vector<FitProgress>& history() const { return history_; }
  const std::vector<std::string>& folded_faces() const { return folded_faces_; }
  Status status() const { return status_; }
  bool stopped() const { return options_->should_stop && options_->should_stop(); }

  /// Whether its rounds are told to FitOptions::on_progress.
  bool tells = true;

 private:
  FitPhase phase(model::Stage stage, std::vector<std::string> vary, double bending,
                 int evaluations) const;
  void run(FitPhase& phase, const std::string& name, int rounds, double first, double last);
  void unfold(FitPhase& phase);
  void one_round(FitPhase& phase, const std::string& name, int index, int rounds,
                 const FitRound& round);

  const std::vector<FitTargetMaker>* targets_;
  const FitOptions* options_;
  model::Model model_;
  Clock::time_point begin_;
  std::vector<FitProgress> history_;
  std::vector<std::string> folded_faces_;
  Status status_ = Status::failed;
  double misfit_ = 0.0;
};

}  // namespace bodyline::optimize
