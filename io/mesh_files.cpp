#include "io/mesh_files.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <charconv>
#include <cstring>

namespace bodyline::io {
namespace {

static_assert(std::endian::native == std::endian::little, "the binary formats are little endian");

template <typename Value>
void append(std::string& file, const Value& value) {
  file.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

void append(std::string& file, const Eigen::Vector3f& vector) {
  for (int c = 0; c < 3; ++c) append(file, vector[c]);
}

/// The shortest text that reads back as the same number.
template <typename Number>
void append_text(std::string& file, Number number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof(text), number);
  file.append(text, end.ptr);
}

void append_line(std::string& file, const char* keyword, const Eigen::Vector3f& vector) {
  file += keyword;
  for (int c = 0; c < 3; ++c) {
    file += ' ';
    append_text(file, vector[c]);
  }
  file += '\n';
}

std::vector<Eigen::Vector3f> mean_normals(const Mesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.points.size(), Eigen::Vector3f::Zero());
  std::vector<int> only(mesh.points.size(),
                        -1);  // the one normal of a smooth point, -2 where there are more
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int point = mesh.triangles[t][k], normal = mesh.triangle_normals[t][k];
      normals[point] += mesh.normals[normal];
      only[point] = only[point] == -1 || only[point] == normal ? normal : -2;
    }
  }
  for (std::size_t p = 0; p < normals.size(); ++p)
    normals[p] = only[p] >= 0 ? mesh.normals[only[p]] : normals[p].normalized();
  return normals;
}

}  // namespace

std::string stl_file(const Mesh& mesh) {
  std::string file = "Bodyline, units: mm";  // must not begin with "solid"
  file.resize(80, ' ');
  append(file, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]],
                          &c = mesh.points[triangle[2]];
    append(file, Eigen::Vector3f((b - a).cross(c - a).normalized()));
    append(file, a);
    append(file, b);
    append(file, c);
    append(file, std::uint16_t{0});
  }
  return file;
}

std::string obj_file(const Mesh& mesh) {
  std::string file = "# Bodyline, units: mm, z up\n";
  for (const auto& point : mesh.points) append_line(file, "v", point);
  for (const auto& normal : mesh.normals) append_line(file, "vn", normal);
  for (const MeshPart& part : mesh.parts) {
    file += "g " + part.name + "\n";
    for (int t = part.first_triangle; t < part.first_triangle + part.triangles; ++t) {
      file += 'f';
      for (int k = 0; k < 3; ++k) {
        file += ' ';
        append_text(file, mesh.triangles[t][k] + 1);
        file += "//";
        append_text(file, mesh.triangle_normals[t][k] + 1);
      }
      file += '\n';
    }
  }
  return file;
}

std::string ply_file(const Mesh& mesh) {
  std::string file = "ply\nformat binary_little_endian 1.0\ncomment Bodyline, units: mm, z up\n";
  for (const MeshPart& part : mesh.parts)
    file += "comment face " + part.name + " triangles " + std::to_string(part.first_triangle) +
            " to " + std::to_string(part.first_triangle + part.triangles - 1) + "\n";
  file += "element vertex " + std::to_string(mesh.points.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    file += std::string("property float ") + name + "\n";
  file += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  file += "property list uchar int vertex_indices\nend_header\n";
  const auto normals = mean_normals(mesh);
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    append(file, mesh.points[p]);
    append(file, normals[p]);
  }
  for (const auto& triangle : mesh.triangles) {
    append(file, std::uint8_t{3});
    for (int point : triangle) append(file, static_cast<std::int32_t>(point));
  }
  return file;
}

}  // namespace bodyline::io
