#pragma once

#include <deque>
#include <vector>

#include "model/batch_tables.hpp"
#include "model/body_plan.hpp"

namespace bodyline::model {

/// Groups the steps of a body by what is done to them, up to `lanes` of a group at a time: 1, 2, 4
/// or 8.
class BatchPlan {
 public:
  BatchPlan(const BodyPlan& plan, int lanes);
  BatchPlan(const BatchPlan&) = delete;
  BatchPlan& operator=(const BatchPlan&) = delete;

  /// Valid as long as this object.
  const BatchTables& tables() const { return tables_; }

 private:
  friend class BatchPlanner;
  std::deque<std::vector<int>> offsets_;
  std::deque<std::vector<double>> numbers_;
  std::vector<PatchBatch> patches_;
  std::vector<SeamBatch> seams_;
  std::vector<SideBatch> sides_;
  std::vector<CornerBatch> corners_;
  std::vector<SideBatch> bend_sides_;
  std::vector<CornerBatch> bend_corners_;
  BatchTables tables_;
};

}  // namespace bodyline::model
