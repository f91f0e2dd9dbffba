#pragma once

#include <string>
#include <vector>

#include "model/kernels.hpp"
#include "model/surface.hpp"

/// What an evaluator sums up (docs/mathematics.md, section 9). Values are those of the whole body,
/// both sides.
namespace bodyline::model {

enum class TermKind {
  bending,    ///< integral of (k1^2 + k2^2) dA; no unit
  variation,  ///< integral of |grad_S H|^2 dA times the area of the stage's faces; no unit
  area,       ///< area, m^2
  fold,  ///< barrier against folded faces: sum over faces of the mean penalty at their nodes; no
         ///< unit
  closeness,  ///< mean squared distance of the base nets' points from those of the start, mm^2
};

/// "bending", ...; term_kind throws std::invalid_argument listing the names.
std::string term_name(TermKind kind);
TermKind term_kind(const std::string& name);
std::vector<std::string> term_names();

/// One weighted term of an objective.
struct Term {
  TermKind kind = TermKind::bending;
  double weight = 1.0;
  Stage stage = Stage::body;
  std::vector<std::string> faces;  ///< patterns of face names; empty means all faces of the stage
};

}  // namespace bodyline::model
