#include "model/check_body.hpp"

#include "model/body_plan.hpp"
#include "model/build.hpp"
#include "model/check_warnings.hpp"
#include "model/measures_wheelbase.hpp"

namespace bodyline::model {
namespace {

void append_edges(const Model& model, const BodyPlan& plan, Stage stage,
                  const std::vector<Surface>& faces, int samples, std::vector<EdgeCheck>& edges) {
  int corner = 0;
  for (const BodyEdge& edge : list_edges(model, plan, stage)) {
    EdgeCheck check{edge.name, edge.kind, stage, edge_deviation(faces, edge, samples)};
    if (edge.kind == EdgeKind::corner) {
      check.pillar = plan.corners[corner++].shape.seam;
      check.polynomial = !faces[edge.sides.front().a.face].blend.has_value();
    }
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

BodyTotals body_totals(const Model& model, const std::vector<Surface>& faces,
                       const BodyCheck& check) {
  BodyTotals totals;
  double variation = 0.0;
  for (const FaceCheck& face : check.faces) {
    if (face.stage != check.stage) continue;
    const double times = face.mirrored ? 2.0 : 1.0;
    totals.area_mm2 += times * face.integrals.area_mm2;
    totals.bending += times * face.integrals.bending;
    variation += times * face.integrals.variation_per_mm2;
    totals.faces += face.mirrored ? 2 : 1;
  }
  totals.variation_times_area = variation * totals.area_mm2;
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
  std::vector<Surface> faces = build(model, Stage::base, Halves::left_and_central);
  append_edges(model, plan, Stage::base, faces, options.edge_samples, check.edges);
  append_faces(faces, Stage::base, options, check.faces);
  if (options.stage != Stage::base) {
    faces = build(model, options.stage, Halves::left_and_central);
    append_edges(model, plan, options.stage, faces, options.edge_samples, check.edges);
    append_faces(faces, options.stage, options, check.faces);
  }
  check.totals = body_totals(model, faces, check);
  check.warnings = body_warnings(model, plan, options.stage);
  return check;
}

}  // namespace bodyline::model
