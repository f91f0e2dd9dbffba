#include "cli/refine_model.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

#include "io/body_net.hpp"
#include "model/build.hpp"
#include "strokes/insert_strokes.hpp"
#include "strokes/refined_body.hpp"
#include "strokes/symmetric_strokes.hpp"

namespace bodyline::cli {
namespace {

int find_face(const model::FaceNet& net, const std::string& name) {
  for (std::size_t k = 0; k < net.faces.size(); ++k)
    if (net.faces[k].surface.name == name) return static_cast<int>(k);
  return -1;
}

const model::Surface& find_patch(const std::vector<model::Surface>& faces,
                                 const std::string& name) {
  constexpr std::string_view image = ".right";
  if (name.ends_with(image))
    throw std::invalid_argument("'" + name + "' is a mirror image: refine '" +
                                name.substr(0, name.size() - image.size()) +
                                "' on the left, and both halves are refined alike");
  std::string known;
  for (const model::Surface& face : faces) {
    if (face.kind != model::FaceKind::patch) continue;
    if (face.name == name) return face;
    if (!face.name.ends_with(".right")) known += (known.empty() ? "" : ", ") + face.name;
  }
  throw std::invalid_argument("the model has no patch '" + name + "'; it has " + known);
}

double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// Keeps of a check what it says of some faces.
void keep(model::FaceNetCheck& check, const std::set<int>& faces) {
  std::erase_if(check.edges, [&](const model::NetEdgeCheck& edge) {
    return !faces.contains(edge.face_a) && !faces.contains(edge.face_b);
  });
  check.worst = {};
  for (const model::NetEdgeCheck& edge : check.edges) {
    const model::EdgeDeviation& other = edge.deviation;
    if (!(other.normal_deviation_deg <= check.worst.normal_deviation_deg))
      check.worst.worst_point = other.worst_point;
    check.worst.gap_mm = larger(other.gap_mm, check.worst.gap_mm);
    check.worst.normal_deviation_deg =
        larger(other.normal_deviation_deg, check.worst.normal_deviation_deg);
    check.worst.curvature_jump_per_mm =
        larger(other.curvature_jump_per_mm, check.worst.curvature_jump_per_mm);
  }
  for (int f = 0; f < static_cast<int>(check.faces.size()); ++f)
    if (!faces.contains(f)) check.faces[f].folded = false;
}

/// Largest angle between some faces and the others.
double border_angle(const model::FaceNetCheck& check, const std::set<int>& faces) {
  double largest = 0.0;
  for (const model::NetEdgeCheck& edge : check.edges)
    if (faces.contains(edge.face_a) != faces.contains(edge.face_b))
      largest = larger(edge.deviation.normal_deviation_deg, largest);
  return largest;
}

std::set<int> faces_called(const model::FaceNet& net, const std::string& name) {
  std::set<int> faces;
  for (int f = 0; f < static_cast<int>(net.faces.size()); ++f) {
    const std::string& own = net.faces[f].surface.name;
    for (const std::string& wanted : {name, name + ".right"})
      if (own == wanted || own.starts_with(wanted + " ")) faces.insert(f);
  }
  return faces;
}

// A patch on the middle is its own mirror image, and stays so.
std::vector<model::Stroke> with_images(const std::vector<model::Stroke>& strokes,
                                       const model::Surface& face,
                                       const strokes::BuildOptions& options) {
  return strokes::symmetric_strokes(
      strokes, options.threshold_mm.value_or(strokes::usual_threshold({face.net})));
}

}  // namespace

RefinedModel refine_model(const model::Model& model, const std::string& patch,
                          const std::vector<model::Stroke>& strokes,
                          const strokes::BuildOptions& options) {
  const std::vector<model::Surface> faces = model::build(model, model::Stage::body);
  const model::Surface& face = find_patch(faces, patch);
  const model::FaceNet body = io::body_net(faces, model.name);
  const int image = find_face(body, patch + ".right");
  RefinedModel refined{
      strokes::refine_patch(face, image >= 0 ? strokes : with_images(strokes, face, options),
                            options),
      body,
      {},
      0.0,
      0.0};
  const strokes::Net& net = refined.build.surface.net;
  refined.border_before_deg =
      border_angle(model::check_face_net(refined.net), faces_called(refined.net, patch));
  refined.net = strokes::refined_body(refined.net, find_face(refined.net, patch), net);
  if (image >= 0)
    refined.net =
        strokes::refined_mirror_image(refined.net, find_face(refined.net, patch + ".right"), net);
  refined.check = model::check_face_net(refined.net);
  const std::set<int> added = faces_called(refined.net, patch);
  refined.border_deg = border_angle(refined.check, added);
  keep(refined.check, added);
  return refined;
}

}  // namespace bodyline::cli
