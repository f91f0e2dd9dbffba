#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "model/body_plan.hpp"
#include "model/face_rule.hpp"
#include "model/objective.hpp"

/// Which terms of an objective are integrated on which faces, planned once.
namespace bodyline::model {

/// Begin and end of a run of numbers.
using NumberRange = std::pair<int, int>;

/// What is summed on one face, with which quadrature.
struct FaceWork {
  const FaceRule* rule = nullptr;
  int net = 0, blend = -1;  ///< offsets in numbers
  int numbers = 0;          ///< of the net
  std::vector<int> terms;   ///< indices into the terms
  std::vector<int> slots;   ///< where each term's value of this face goes
  int area_slot = -1;       ///< also sum the area, for the product in the variation term
};

/// All faces' work. Values go to slots, so that they are added in the same order whoever computes
/// them.
struct FaceWorkPlan {
  std::map<std::tuple<int, int, Range, bool>, FaceTables> tables;
  std::vector<FaceWork> faces;
  std::vector<NumberRange> term_slots;  ///< of each term; empty where it is not one of faces
  NumberRange area_slots{0, 0};
  std::vector<NumberRange> between;  ///< numbers in no face's net or blend
  int slot_count = 0;
  Stage stage = Stage::base;  ///< the furthest that a term on faces needs
  bool has_variation = false;
};

/// Whether a kind is integrated over faces.
bool is_on_faces(TermKind kind);

/// Throws std::invalid_argument when a pattern matches no face, the number of nodes is not allowed,
/// or the variation occurs twice.
FaceWorkPlan plan_face_work(const BodyPlan& plan, const std::vector<Term>& terms, int nodes);

/// The faces dealt to `members` so that all have about the same to do.
std::vector<std::vector<const FaceWork*>> deal_faces(const FaceWorkPlan& plan, int members);

}  // namespace bodyline::model
