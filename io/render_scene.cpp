#include "io/render_scene.hpp"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace bodyline::io {
namespace {

// Corners of the two triangles of a cell, as offsets in (i, j); both turn the same way as S_u x
// S_v.
struct CellTriangle {
  int i[3], j[3];
};
constexpr CellTriangle cell_triangles[2] = {{{0, 1, 1}, {0, 0, 1}}, {{0, 1, 0}, {0, 1, 1}}};

void attach_grid(RTCDevice device, RTCScene scene, const FaceGrid& grid, unsigned id) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               grid.points.size()));
  const int n = grid.cells;
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), static_cast<std::size_t>(2) * n * n));
  if (vertices == nullptr || indices == nullptr) {
    rtcReleaseGeometry(geometry);
    throw std::runtime_error("the ray tracer has no memory for the body");
  }
  for (const Eigen::Vector3d& point : grid.points) {
    for (int c = 0; c < 3; ++c) *vertices++ = static_cast<float>(point[c]);
  }
  for (int cell = 0; cell < n * n; ++cell) {
    for (const CellTriangle& triangle : cell_triangles) {
      for (int k = 0; k < 3; ++k) {
        const int i = cell / n + triangle.i[k], j = cell % n + triangle.j[k];
        *indices++ = static_cast<std::uint32_t>(i * (n + 1) + j);
      }
    }
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

RTCRay embree_ray(const Ray& ray, double nearest) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x());
  r.org_y = static_cast<float>(ray.origin.y());
  r.org_z = static_cast<float>(ray.origin.z());
  r.dir_x = static_cast<float>(ray.direction.x());
  r.dir_y = static_cast<float>(ray.direction.y());
  r.dir_z = static_cast<float>(ray.direction.z());
  r.tnear = static_cast<float>(nearest);
  r.tfar = std::numeric_limits<float>::infinity();
  r.mask = ~0u;
  return r;
}

}  // namespace

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  int cells = 1;

  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const std::vector<FaceGrid>& grids) : embree_(std::make_unique<Embree>()) {
  // A device limited to fewer threads would limit every other user of TBB in the process as well.
  embree_->device = rtcNewDevice(nullptr);
  if (embree_->device == nullptr) throw std::runtime_error("the ray tracer cannot start");
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  if (!grids.empty()) embree_->cells = grids.front().cells;
  for (std::size_t f = 0; f < grids.size(); ++f) {
    attach_grid(embree_->device, embree_->scene, grids[f], static_cast<unsigned>(f));
  }
  // Built by one thread: the tree, and with it which of two equally near triangles is met, is
  // always the same.
  tbb::task_arena one_thread(1);
  one_thread.execute([&] { rtcCommitScene(embree_->scene); });
  if (rtcGetDeviceError(embree_->device) != RTC_ERROR_NONE) {
    throw std::runtime_error("the ray tracer cannot take in the body");
  }
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::optional<Hit> RayScene::first_hit(const Ray& ray, double nearest) const {
  RTCRayHit query{};
  query.ray = embree_ray(ray, nearest);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  const int n = embree_->cells, cell = static_cast<int>(query.hit.primID / 2);
  const CellTriangle& triangle = cell_triangles[query.hit.primID % 2];
  const double b1 = query.hit.u, b2 = query.hit.v, b0 = 1.0 - b1 - b2;
  Hit hit;
  hit.face = static_cast<int>(query.hit.geomID);
  hit.u = (cell / n + b0 * triangle.i[0] + b1 * triangle.i[1] + b2 * triangle.i[2]) / n;
  hit.v = (cell % n + b0 * triangle.j[0] + b1 * triangle.j[1] + b2 * triangle.j[2]) / n;
  hit.distance = query.ray.tfar;
  const Eigen::Vector3d normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
  hit.along_normal = normal.dot(ray.direction) > 0.0;
  return hit;
}

bool RayScene::blocked(const Ray& ray, double nearest) const {
  RTCRay query = embree_ray(ray, nearest);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0.0f;
}

}  // namespace bodyline::io
