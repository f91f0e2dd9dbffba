#include "model/face_work.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/face_selection.hpp"

namespace bodyline::model {
namespace {

constexpr int numbers_per_point = 3;

class Planner {
 public:
  Planner(const BodyPlan& body, int nodes) : body_(body), nodes_(nodes) {}

  void add_term(int index, const Term& term);
  void add_area(const Term& term);
  FaceWorkPlan finish();

 private:
  FaceWork& work_of(const Face& face);
  const FaceRule* rule_for(const Face& face);

  const BodyPlan& body_;
  int nodes_;
  FaceWorkPlan plan_;
  std::map<int, FaceWork> by_net_;
};

const FaceRule* Planner::rule_for(const Face& face) {
  const auto key =
      std::make_tuple(face.degree_u, face.degree_v, summed_range(face), face.blend >= 0);
  const auto found = plan_.tables.find(key);
  if (found != plan_.tables.end()) return &found->second.rule();
  return &plan_.tables
              .try_emplace(key, face.degree_u, face.degree_v, nodes_, summed_range(face),
                           face.blend >= 0)
              .first->second.rule();
}

FaceWork& Planner::work_of(const Face& face) {
  FaceWork& work = by_net_[face.net];
  work.rule = rule_for(face);
  work.net = numbers_per_point * face.net;
  work.numbers = numbers_per_point * (face.degree_u + 1) * (face.degree_v + 1);
  work.blend = face.blend < 0 ? -1 : numbers_per_point * face.blend;
  return work;
}

void Planner::add_term(int index, const Term& term) {
  const int first = plan_.slot_count;
  if (is_on_faces(term.kind)) {
    plan_.stage = std::max(plan_.stage, term.stage);
    for (const Face* face : choose_faces(body_, term.stage, term.faces)) {
      FaceWork& work = work_of(*face);
      work.terms.push_back(index);
      work.slots.push_back(plan_.slot_count++);
    }
  }
  plan_.term_slots.emplace_back(first, plan_.slot_count);
}

// The area of the term's whole stage, which multiplies the variation.
void Planner::add_area(const Term& term) {
  if (plan_.has_variation)
    throw std::invalid_argument("an objective can hold the variation term once");
  plan_.has_variation = true;
  plan_.area_slots.first = plan_.slot_count;
  for (const Face& face : body_.faces(term.stage)) work_of(face).area_slot = plan_.slot_count++;
  plan_.area_slots.second = plan_.slot_count;
}

// The numbers of no face, between the faces' nets and blends.
std::vector<NumberRange> between_faces(const std::vector<FaceWork>& faces, int number_count) {
  std::vector<NumberRange> used;
  for (const FaceWork& w : faces) {
    used.push_back({w.net, w.net + w.numbers});
    if (w.blend >= 0) used.push_back({w.blend, w.blend + numbers_per_point});
  }
  std::sort(used.begin(), used.end());
  std::vector<NumberRange> rest;
  int end = 0;
  for (const NumberRange& range : used) {
    if (end < range.first) rest.push_back({end, range.first});
    end = range.second;
  }
  if (end < number_count) rest.push_back({end, number_count});
  return rest;
}

FaceWorkPlan Planner::finish() {
  for (auto& entry : by_net_) plan_.faces.push_back(std::move(entry.second));
  plan_.between = between_faces(plan_.faces, numbers_per_point * body_.point_count);
  return std::move(plan_);
}

}  // namespace

bool is_on_faces(TermKind kind) { return kind != TermKind::closeness; }

FaceWorkPlan plan_face_work(const BodyPlan& body, const std::vector<Term>& terms, int nodes) {
  Planner planner(body, nodes);
  for (int t = 0; t < int(terms.size()); ++t) planner.add_term(t, terms[t]);
  for (const Term& term : terms) {
    if (term.kind == TermKind::variation) planner.add_area(term);
  }
  return planner.finish();
}

// Faces by falling cost, each to the member with the least so far.
std::vector<std::vector<const FaceWork*>> deal_faces(const FaceWorkPlan& plan, int members) {
  std::vector<const FaceWork*> order;
  for (const FaceWork& w : plan.faces) order.push_back(&w);
  const auto cost = [](const FaceWork* w) {
    // The part of a face's cost that its degrees do not change, in points of a net.
    constexpr int nodes = 40;
    return (nodes + (w->rule->degree_u + 1) * (w->rule->degree_v + 1)) *
           int(w->terms.size() + (w->area_slot >= 0));
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return cost(a) > cost(b); });
  std::vector<std::vector<const FaceWork*>> shares(members);
  std::vector<int> load(members, 0);
  for (const FaceWork* w : order) {
    const auto least = std::min_element(load.begin(), load.end()) - load.begin();
    shares[least].push_back(w);
    load[least] += cost(w);
  }
  return shares;
}

}  // namespace bodyline::model
