#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/read_scan.hpp"

namespace bodyline::io {

/// A mesh as files of scans hold it; nothing is required of it.
struct ScanMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into `points`
};

/// The most triangles that are read from one file.
inline constexpr std::size_t most_triangles = 20'000'000;

/// Adds a polygon as a fan of triangles around its first corner. False, and nothing added, when the
/// mesh would have more than `most_triangles`.
bool append_polygon(ScanMesh& mesh, std::span<const std::uint32_t> corners);

/// Points spread over a mesh, with the normals of the triangles as they are wound: the area is
/// divided into `count` equal parts in the order of the triangles, and each part gets one point at
/// a random place. Triangles with points that are not usable have no area; none at all when the
/// whole mesh has none.
model::Scan sample_mesh(const ScanMesh& mesh, std::size_t count, std::uint64_t seed);

/// The scan of a mesh file. Throws InputError when the mesh has no area.
ScanFile scan_from_mesh(const std::filesystem::path& path, const ScanMesh& mesh,
                        const ReadScanOptions& options, std::string format);

}  // namespace bodyline::io
