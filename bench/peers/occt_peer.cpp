#include <GeomAdaptor_Surface.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "bench/peers/peers.hpp"

namespace bodyline::bench {
namespace {

template <class Surface>
void surface_jets(const Surface& surface, const Patch& patch, double* out) {
  gp_Pnt p;
  gp_Vec d[5];
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      surface.D2(patch.parameters[ku], patch.parameters[kv], p, d[0], d[1], d[2], d[4], d[3]);
      *out++ = p.X();
      *out++ = p.Y();
      *out++ = p.Z();
      for (const gp_Vec& x : d) {
        *out++ = x.X();
        *out++ = x.Y();
        *out++ = x.Z();
      }
    }
  }
}

}  // namespace

struct OcctPatch::Impl {
  Handle(Geom_BezierSurface) surface;
  GeomAdaptor_Surface adaptor;
};

OcctPatch::OcctPatch(const Patch& patch) : impl_(std::make_unique<Impl>()) {
  TColgp_Array2OfPnt points(1, Patch::points, 1, Patch::points);
  for (int i = 0; i < Patch::points; ++i) {
    for (int j = 0; j < Patch::points; ++j) {
      const double* p = &patch.net[(i * Patch::points + j) * 3];
      points(i + 1, j + 1) = gp_Pnt(p[0], p[1], p[2]);
    }
  }
  impl_->surface = new Geom_BezierSurface(points);
  impl_->adaptor.Load(impl_->surface);
}

OcctPatch::~OcctPatch() = default;

void OcctPatch::jets(const Patch& patch, double* out) const {
  surface_jets(*impl_->surface, patch, out);
}

void OcctPatch::jets_adaptor(const Patch& patch, double* out) const {
  surface_jets(impl_->adaptor, patch, out);
}

void OcctPatch::curvature(const Patch& patch, double* mean, double* gauss) const {
  constexpr double resolution = 1e-9;
  GeomLProp_SLProps properties(impl_->surface, 2, resolution);
  for (int kv = 0; kv < Patch::nodes; ++kv) {
    for (int ku = 0; ku < Patch::nodes; ++ku) {
      properties.SetParameters(patch.parameters[ku], patch.parameters[kv]);
      *mean++ = properties.MeanCurvature();
      *gauss++ = properties.GaussianCurvature();
    }
  }
}

}  // namespace bodyline::bench
