#pragma once

#include <map>
#include <utility>
#include <vector>

#include "model/face_rule.hpp"
#include "model/kernels.hpp"

/// Measures that are summed over the faces of the closed body. None allocates after construction;
/// the plan must outlive them.
namespace bodyline::explore {

/// A face with the tables it is sampled by.
struct SampledFace {
  const model::Face* face = nullptr;
  const model::FaceTables* tables = nullptr;
};

/// The faces of the body with their tables; those of degree above 5 with `nodes_high` nodes.
class SampledFaces {
 public:
  SampledFaces(const model::BodyPlan& plan, int nodes, int nodes_high,
               model::FaceTables::MakeRule make_rule);
  const std::vector<SampledFace>& list() const { return list_; }
  /// Room for the jets of any of the faces, to first order.
  std::vector<double> room() const;

 private:
  std::map<std::pair<int, std::pair<int, int>>, model::FaceTables> tables_;
  std::vector<SampledFace> list_;
};

/// Finds faces that fold over themselves: a normal is turned by more than 90 degrees against the
/// mean normal. Looks at 64 of them, those of the edges and corners among them, and from the worst
/// one further around it when that is turned by 80 degrees or more.
class FoldMeter {
 public:
  explicit FoldMeter(const model::BodyPlan& plan);
  /// Number of folded faces on both sides, or with `any` something above 0 when there is one;
  /// `first` becomes the index of the first in the plan's faces, or -1.
  int measure(const double* nets, bool any, int& first);

 private:
  SampledFaces faces_;
  const model::Kernels* kernels_;
  std::vector<double> jets_;
};

/// The volume of model/measures.hpp, m^3.
class VolumeMeter {
 public:
  explicit VolumeMeter(const model::BodyPlan& plan);
  double measure(const double* nets);

 private:
  SampledFaces faces_;
  const model::Kernels* kernels_;
  std::vector<double> jets_;
};

}  // namespace bodyline::explore
