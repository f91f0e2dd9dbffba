#include <embree3/rtcore.h>
#include <Extrema_GenLocateExtPS.hxx>
#include <Extrema_POnSurf.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "bench/peers/fit_peers.hpp"

namespace bodyline::bench {
namespace {

struct Samples {
  std::vector<Eigen::Vector3d> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t k, std::size_t axis) const {
    return points[k][Eigen::Index(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// Nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Eigen::Vector3f nearest_of_triangle(const Eigen::Vector3f& p, const Eigen::Vector3f& a,
                                    const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a, ac = c - a, ap = p - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return a;
  const Eigen::Vector3f bp = p - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0f && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return a + d1 / (d1 - d3) * ab;
  const Eigen::Vector3f cp = p - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0f && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float scale = 1.0f / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

}  // namespace

struct OcctNearest::Impl {
  FitFace face;
  GeomAdaptor_Surface surface;
};

OcctNearest::OcctNearest(const FitFace& face) : impl_(std::make_unique<Impl>()) {
  impl_->face = face;
  TColgp_Array2OfPnt points(1, face.degree_u + 1, 1, face.degree_v + 1);
  for (int i = 0, at = 0; i <= face.degree_u; ++i) {
    for (int j = 0; j <= face.degree_v; ++j, at += 3)
      points(i + 1, j + 1) = gp_Pnt(face.net[at], face.net[at + 1], face.net[at + 2]);
  }
  impl_->surface.Load(new Geom_BezierSurface(points));
}
OcctNearest::~OcctNearest() = default;

double OcctNearest::nearest(std::size_t first, std::size_t count) const {
  double sum = 0.0;
  for (std::size_t k = first; k < first + count; ++k) {
    const Eigen::Vector3d& p = impl_->face.targets[k];
    Extrema_GenLocateExtPS extrema(impl_->surface, 1e-9, 1e-9);
    extrema.Perform(gp_Pnt(p.x(), p.y(), p.z()), impl_->face.parameters[k][0],
                    impl_->face.parameters[k][1]);
    if (extrema.IsDone()) sum += extrema.SquareDistance();
  }
  return sum;
}

struct NanoflannNearest::Impl {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Samples>,
                                                   Samples, 3>;
  Samples samples;
  std::unique_ptr<Tree> tree;
};

NanoflannNearest::NanoflannNearest(std::vector<Eigen::Vector3d> samples)
    : impl_(std::make_unique<Impl>()) {
  impl_->samples.points = std::move(samples);
  impl_->tree = std::make_unique<Impl::Tree>(3, impl_->samples,
                                             nanoflann::KDTreeSingleIndexAdaptorParams(10));
  impl_->tree->buildIndex();
}
NanoflannNearest::~NanoflannNearest() = default;

double NanoflannNearest::nearest(const std::vector<Eigen::Vector3d>& points, std::size_t first,
                                 std::size_t count) const {
  double sum = 0.0;
  for (std::size_t k = first; k < first + count; ++k) {
    unsigned index = 0;
    double squared = 0.0;
    impl_->tree->knnSearch(points[k].data(), 1, &index, &squared);
    sum += squared;
  }
  return sum;
}

struct EmbreeNearest::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
};

EmbreeNearest::EmbreeNearest(const std::vector<Eigen::Vector3d>& vertices,
                             const std::vector<std::array<int, 3>>& triangles)
    : impl_(std::make_unique<Impl>()) {
  for (const Eigen::Vector3d& v : vertices) impl_->vertices.push_back(v.cast<float>());
  for (const auto& t : triangles)
    impl_->triangles.push_back({unsigned(t[0]), unsigned(t[1]), unsigned(t[2])});
  impl_->device = rtcNewDevice(nullptr);
  impl_->scene = rtcNewScene(impl_->device);
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const v = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, impl_->vertices.size()));
  for (std::size_t k = 0; k < impl_->vertices.size(); ++k)
    for (int c = 0; c < 3; ++c) v[3 * k + c] = impl_->vertices[k][c];
  auto* const t = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, impl_->triangles.size()));
  for (std::size_t k = 0; k < impl_->triangles.size(); ++k)
    for (int c = 0; c < 3; ++c) t[3 * k + c] = impl_->triangles[k][c];
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}
EmbreeNearest::~EmbreeNearest() {
  rtcReleaseScene(impl_->scene);
  rtcReleaseDevice(impl_->device);
}

double EmbreeNearest::nearest(const std::vector<Eigen::Vector3d>& points, std::size_t first,
                              std::size_t count) const {
  double sum = 0.0;
  for (std::size_t k = first; k < first + count; ++k) {
    const Eigen::Vector3f p = points[k].cast<float>();
    RTCPointQuery query{p.x(), p.y(), p.z(), 0.0f, std::numeric_limits<float>::infinity()};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const auto visit = [](RTCPointQueryFunctionArguments* a) {
      const Impl& mesh = *static_cast<const Impl*>(a->userPtr);
      const auto& t = mesh.triangles[a->primID];
      const Eigen::Vector3f at(a->query->x, a->query->y, a->query->z);
      const float distance =
          (nearest_of_triangle(at, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]) -
           at)
              .norm();
      if (distance >= a->query->radius) return false;
      a->query->radius = distance;
      return true;
    };
    rtcPointQuery(impl_->scene, &query, &context, visit, impl_.get());
    sum += double(query.radius) * double(query.radius);
  }
  return sum;
}

}  // namespace bodyline::bench
