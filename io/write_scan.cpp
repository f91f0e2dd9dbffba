#include "io/write_scan.hpp"

#include <bit>
#include <stdexcept>
#include <string>

namespace bodyline::io {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little endian");

template <typename Number>
void append(std::string& file, const Eigen::Vector3d& vector) {
  for (const double coordinate : vector) {
    const auto number = static_cast<Number>(coordinate);
    file.append(reinterpret_cast<const char*>(&number), sizeof(Number));
  }
}

std::string head(const model::Scan& scan) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment Bodyline\nelement vertex ";
  text += std::to_string(scan.points.size()) + "\n";
  for (const char* name : {"x", "y", "z"}) text += std::string("property double ") + name + "\n";
  if (!scan.normals.empty()) {
    for (const char* name : {"nx", "ny", "nz"})
      text += std::string("property float ") + name + "\n";
  }
  return text + "end_header\n";
}

}  // namespace

std::string scan_file(const model::Scan& scan) {
  const bool with_normals = !scan.normals.empty();
  if (with_normals && scan.normals.size() != scan.points.size()) {
    throw std::invalid_argument("a scan needs one normal a point, or none at all");
  }
  std::string file = head(scan);
  const std::size_t point_size = 3 * sizeof(double) + (with_normals ? 3 * sizeof(float) : 0);
  file.reserve(file.size() + scan.points.size() * point_size);
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    append<double>(file, scan.points[k]);
    if (with_normals) append<float>(file, scan.normals[k]);
  }
  return file;
}

void write_scan(const model::Scan& scan, const std::filesystem::path& path, Overwrite overwrite) {
  write_file(path, scan_file(scan), overwrite);
}

}  // namespace bodyline::io
