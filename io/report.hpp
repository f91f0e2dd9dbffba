#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/write_file.hpp"
#include "model/model.hpp"

namespace bodyline::io {

/// One line of a report's table of objective terms; values of the whole body.
struct ReportTerm {
  std::string name;
  double weight = 0.0;
  double before = 0.0, after = 0.0;
};

/// One tuned variable.
struct ReportVariable {
  std::string name;
  double before = 0.0, after = 0.0;
  double lower = 0.0, upper = 0.0;
};

/// One improvement of the search.
struct ReportStep {
  int evaluation = 0;
  double value = 0.0, gradient_norm = 0.0, seconds = 0.0;
};

/// What the report of a tuning run shows. Plain data: the run itself is known to no one here.
struct FairReport {
  std::string title;    ///< for example "model1, tuned"
  std::string status;   ///< how the search ended, in words
  std::string command;  ///< the command line that repeats it
  model::Model before, after;
  std::vector<ReportTerm> terms;
  std::vector<ReportVariable> variables;
  std::vector<ReportStep> history;
  std::vector<std::string> folded_faces;
  double value_before = 0.0, value_after = 0.0;
  int evaluations = 0;
  double seconds = 0.0;
};

/// Writes one self-contained HTML page (no network, no scripts from elsewhere): verdict, pictures
/// before and after, objective terms, bending per face, continuity, how the search went, what
/// moved. Throws as write_file does.
void write_fair_report(const FairReport& report, const std::filesystem::path& path,
                       Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
