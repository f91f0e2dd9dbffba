#include "model/check_body.hpp"

#include "model/body_plan.hpp"
#include "model/build.hpp"
#include "model/check_warnings.hpp"
#include "model/measures_wheelbase.hpp"

namespace bodyline::model {
namespace {

void append_edges(const Model& model, const BodyPlan& plan, Stage stage,
                  const std::vector<Surface>& faces, int samples, std::vector<EdgeCheck>& edges) {
  int corner = 0, joint = 0;
  for (const BodyEdge& edge : list_edges(model, plan, stage)) {
    EdgeCheck check{edge.name, edge.kind, stage, edge_deviation(faces, edge, samples)};
    if (edge.kind == EdgeKind::corner) {
      check.pillar = plan.corners[corner++].shape.seam;
      check.polynomial = !faces[edge.sides.front().a.face].blend.has_value();
    }
    if (edge.kind == EdgeKind::joint) check.continuity = plan.joints[joint++].continuity;
    edges.push_back(std::move(check));
  }
}

void append_faces(const std::vector<Surface>& faces, Stage stage, const BodyCheckOptions& options,
                  std::vector<FaceCheck>& checks) {
  for (const Surface& face : faces) {
    checks.push_back({face.name, face.kind, stage, !face.central,
                      check_fold(face, options.fold_cells), face_integrals(face, options.nodes)});
  }
}

// `faces` are those of the check's stage, the last that it lists.
BodyTotals body_totals(const Model& model, const std::vector<Surface>& faces,
                       const BodyCheck& check) {
  std::vector<FaceIntegrals> integrals;
  for (auto face = check.faces.end() - faces.size(); face != check.faces.end(); ++face)
    integrals.push_back(face->integrals);
  const FaceIntegrals sum = body_integrals(faces, integrals, Halves::left_and_central);
  BodyTotals totals;
  totals.area_mm2 = sum.area_mm2;
  totals.bending = sum.bending;
  totals.variation_times_area = sum.variation_per_mm2 * sum.area_mm2;
  for (const Surface& face : faces)
    totals.faces += int(times_counted(face, Halves::left_and_central));
  if (check.stage != Stage::kept)
    totals.volume_mm3 = enclosed_volume(faces, Halves::left_and_central);
  totals.box = bounding_box(faces, Halves::left_and_central);
  totals.wheelbase_mm = wheelbase(model);
  return totals;
}

}  // namespace

BodyCheck check_body(const Model& model, const BodyCheckOptions& options) {
  const BodyPlan plan = plan_body(model);
  BodyCheck check;
  check.model = model.name;
  check.stage = options.stage;
  const std::vector<Surface> base = build(model, Stage::base, Halves::left_and_central);
  append_edges(model, plan, Stage::base, base, options.edge_samples, check.edges);
  append_faces(base, Stage::base, options, check.faces);
  if (options.stage == Stage::base) {
    check.totals = body_totals(model, base, check);
    return check;
  }
  const std::vector<Surface> faces = build(model, options.stage, Halves::left_and_central);
  append_edges(model, plan, options.stage, faces, options.edge_samples, check.edges);
  append_faces(faces, options.stage, options, check.faces);
  check.totals = body_totals(model, faces, check);
  if (options.stage == Stage::body) check.warnings = body_warnings(model, plan, base, faces);
  return check;
}

}  // namespace bodyline::model
