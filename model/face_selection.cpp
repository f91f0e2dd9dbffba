#include "model/face_selection.hpp"

#include <stdexcept>

#include "model/name_matches.hpp"
#include "model/suggest.hpp"

namespace bodyline::model {
namespace {

void refuse_idle_pattern(const std::vector<Face>& faces, Stage stage, const std::string& pattern) {
  std::vector<std::string> names;
  for (const Face& face : faces) {
    if (name_matches(pattern, face.name)) return;
    names.push_back(face.name);
  }
  throw std::invalid_argument("no face of stage " + std::string(stage_name(stage)) + " matches \"" +
                              pattern + "\"; the nearest is \"" + nearest_name(pattern, names) +
                              "\"");
}

}  // namespace

std::vector<const Face*> choose_faces(const BodyPlan& plan, Stage stage,
                                      std::span<const std::string> patterns) {
  const std::vector<Face>& faces = plan.faces(stage);
  for (const std::string& pattern : patterns) refuse_idle_pattern(faces, stage, pattern);
  std::vector<const Face*> chosen;
  for (const Face& face : faces) {
    if (name_is_chosen(patterns, face.name)) chosen.push_back(&face);
  }
  return chosen;
}

}  // namespace bodyline::model
