#include "model/measures.hpp"

#include <Eigen/Geometry>

#include "model/face_rule.hpp"

namespace bodyline::model {
namespace {

// Sum of f(jet) du dv over a face; exact for polynomials of degree below 2 measure_nodes.
template <class Value, class Function>
Value integrate(const Surface& surface, Value sum, const Function& f) {
  const GaussRule rule = gauss_rule(measure_nodes, 0.0, 1.0);
  for (int k = 0; k < measure_nodes; ++k) {
    for (int l = 0; l < measure_nodes; ++l) {
      sum += rule.weights[k] * rule.weights[l] * f(jet(surface, rule.nodes[k], rule.nodes[l], 1));
    }
  }
  return sum;
}

}  // namespace

FaceIntegrals face_integrals(const Surface& surface, int nodes) {
  const FaceTables tables(surface.degree_u, surface.degree_v, nodes, summed_range(surface),
                          surface.blend.has_value());
  const Kernels& kernel = kernels(best_isa());
  const double* net = surface.net.front().data();
  const double* blend = surface.blend ? surface.blend->data() : nullptr;
  const double times = surface.central ? 2.0 : 1.0;
  return {times * kernel.area(tables.rule(), net, blend),
          times * kernel.bending(tables.rule(), net, blend),
          times * kernel.variation(tables.rule(), net, blend)};
}

double face_area(const Surface& surface) {
  return integrate(surface, 0.0,
                   [](const SurfaceJet& at) { return at.d[1].cross(at.d[2]).norm(); });
}

Eigen::Vector3d vector_area(const Surface& surface) {
  return integrate(surface, Eigen::Vector3d(0.0, 0.0, 0.0),
                   [](const SurfaceJet& at) { return Eigen::Vector3d(at.d[1].cross(at.d[2])); });
}

double times_counted(const Surface& surface, Halves halves) {
  return halves == Halves::both || surface.central ? 1.0 : 2.0;
}

FaceIntegrals body_integrals(const std::vector<Surface>& faces,
                             const std::vector<FaceIntegrals>& of_each, Halves halves) {
  FaceIntegrals total;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const FaceIntegrals& one = of_each[k];
    const double times = times_counted(faces[k], halves);
    total.area_mm2 += times * one.area_mm2;
    total.bending += times * one.bending;
    total.variation_per_mm2 += times * one.variation_per_mm2;
  }
  return total;
}

double enclosed_volume(const std::vector<Surface>& faces, Halves halves) {
  double volume = 0.0;
  for (const Surface& face : faces) {
    const double sum = integrate(face, 0.0, [](const SurfaceJet& at) {
      return at.d[0].z() * (at.d[1].x() * at.d[2].y() - at.d[1].y() * at.d[2].x());
    });
    volume += (face.inward ? -1.0 : 1.0) * times_counted(face, halves) * sum;
  }
  return volume;
}

}  // namespace bodyline::model
