#pragma once

#include <string>
#include <vector>

namespace bodyline::explore {

/// What can be measured on a variant. All values are those of the whole body, both sides.
enum class MetricKind {
  bending,  ///< terms of an objective (model/objective.hpp)
  variation,
  area,  ///< m^2: what air and paint touch
  fold,
  closeness,  ///< to the first model of the study
  length,     ///< sides of the smallest upright box, mm
  width,
  height,
  wheelbase,       ///< mm, between the centres of the wheel arches
  front_overhang,  ///< mm, from the box to the centre of the nearer arch
  rear_overhang,
  rake,          ///< of a face at y = 0 from end to end, degrees from the horizontal
  frontal_area,  ///< m^2, of the outline seen from the front
  volume,        ///< m^3 (model/measures.hpp)
  folds,         ///< number of folded faces
  kink,          ///< largest angle between normals at edges, degrees
  gap,           ///< largest distance of faces at edges, mm
  scan,          ///< root mean square distance of a scan's points, mm
  outline        ///< root mean square distance of drawn outlines, both ways, mm
};

/// "bending", ...; metric_kind throws std::invalid_argument listing the names.
std::string metric_name(MetricKind kind);
MetricKind metric_kind(const std::string& name);
std::vector<std::string> metric_names();

/// "mm", "m2", "m3", "deg", "mm2"; "1" for plain numbers.
std::string metric_unit(MetricKind kind);

/// Whether it is a term of an objective, which an evaluator integrates and differentiates.
bool is_term(MetricKind kind);

}  // namespace bodyline::explore
