#pragma once

#include <string>
#include <vector>

#include "io/report.hpp"
#include "model/check_body.hpp"

namespace bodyline::io {

/// The check of both bodies of a report.
struct ReportFacts {
  model::BodyCheck before, after;
  std::vector<std::string> findings_before, findings_after;
};

/// Checks both. Throws ModelError when a model is not connected.
ReportFacts report_facts(const FairReport& report);

/// Faces that fold over themselves at a stage: at Stage::base whole patches, before their cut.
std::vector<std::string> folded_faces(const model::BodyCheck& check, model::Stage stage);

/// How joints of the finished body meet.
struct JointFacts {
  int joints = 0;
  int kinked = 0;          ///< beyond the tolerance of the check, or without normals
  double worst_deg = 0.0;  ///< NaN when it cannot be computed somewhere
};
JointFacts joint_facts(const model::BodyCheck& check);

}  // namespace bodyline::io
