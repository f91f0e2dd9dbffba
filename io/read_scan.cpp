#include "io/read_scan.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "io/input_error.hpp"
#include "io/read_scan_assimp.hpp"
#include "io/read_scan_off.hpp"
#include "io/read_scan_pcd.hpp"
#include "io/read_scan_ply.hpp"
#include "io/read_scan_stl.hpp"
#include "io/read_scan_text.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

struct ScanFormat {
  const char* extension;
  ScanFile (*read)(const std::filesystem::path&, const ReadScanOptions&);
};

constexpr std::array<ScanFormat, 12> formats{{{".ply", read_scan_ply},
                                              {".stl", read_scan_stl},
                                              {".obj", read_scan_assimp},
                                              {".gltf", read_scan_assimp},
                                              {".glb", read_scan_assimp},
                                              {".off", read_scan_off},
                                              {".xyz", read_scan_text},
                                              {".pts", read_scan_text},
                                              {".asc", read_scan_text},
                                              {".txt", read_scan_text},
                                              {".csv", read_scan_text},
                                              {".pcd", read_scan_pcd}}};

const ScanFormat& format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const ScanFormat& format : formats) {
    if (extension == format.extension) return format;
  }
  std::string known;
  for (const ScanFormat& format : formats)
    known.append(known.empty() ? "" : ", ").append(format.extension);
  throw InputError(path.string(), 0, "",
                   "is of no known format of scans; those are " + known + ".");
}

void check_options(const ReadScanOptions& options) {
  if (std::min(options.most_points, options.mesh_points) >= fewest_scan_points) return;
  throw std::invalid_argument("a scan is read with at least " + std::to_string(fewest_scan_points) +
                              " points");
}

void check_points(const std::filesystem::path& path, const ScanFile& file) {
  const std::size_t left = file.scan.points.size();
  if (left >= fewest_scan_points) return;
  if (left == 0 && file.dropped > 0) {
    throw InputError(path.string(), 0, "",
                     "none of its " + std::to_string(file.points_in_file) +
                         " points can be used: their coordinates are not finite or beyond 1e12.");
  }
  throw InputError(path.string(), 0, "",
                   "holds " + std::to_string(left) +
                       " usable points, too few for a scan; it takes " +
                       std::to_string(fewest_scan_points) + " or more.");
}

}  // namespace

std::vector<std::string> scan_extensions() {
  std::vector<std::string> extensions;
  for (const ScanFormat& format : formats) extensions.emplace_back(format.extension);
  return extensions;
}

ScanFile read_scan(const std::filesystem::path& path, const ReadScanOptions& options) {
  check_options(options);
  ScanFile file = format_of(path).read(path, options);
  check_points(path, file);
  return file;
}

}  // namespace bodyline::io
