#include "io/read_scan_ply.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/ply_values.hpp"
#include "io/scan_collector.hpp"
#include "io/scan_mesh.hpp"

namespace bodyline::io {
namespace {

// A mesh has to be held whole; beyond this its vertices are taken as points.
constexpr std::uint64_t most_mesh_vertices = 10'000'000;

// Where an element holds the numbers of a point: x y z nx ny nz, -1 where it does not.
using PointColumns = std::array<int, 6>;

// The list of a face's vertices, -1 when the element is no face.
int vertex_list(const PlyElement& element) {
  if (element.name != "face") return -1;
  const int list = element.find("vertex_indices", true);
  return list >= 0 ? list : element.find("vertex_index", true);
}

PointColumns point_columns(const ScanInput& input, const PlyElement& vertex) {
  PointColumns columns{};
  const std::array<const char*, 6> names{"x", "y", "z", "nx", "ny", "nz"};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    columns[k] = vertex.find(names[k], false);
    if (k < 3 && columns[k] < 0) {
      input.fail(std::string("its vertices have no property \"") + names[k] + "\".");
    }
  }
  return columns;
}

class PlyReader {
 public:
  PlyReader(ScanInput& input, const PlyHeader& header, const ReadScanOptions& options)
      : header_(header),
        vertex_(vertex_element(input)),
        columns_(point_columns(input, vertex_)),
        values_(input, header),
        collector_(options) {
    for (const PlyElement& element : header.elements) {
      is_mesh_ |= element.count > 0 && vertex_list(element) >= 0;
    }
    is_mesh_ &= vertex_.count <= most_mesh_vertices;
  }

  ScanFile read(const ScanInput& input, const ReadScanOptions& options, std::string format) {
    for (const PlyElement& element : header_.elements) {
      for (std::uint64_t k = 0; k < element.count; ++k) {
        values_.begin(element, k);
        read_element(element);
      }
    }
    if (!is_mesh_) return collector_.finish(std::move(format));
    return scan_from_mesh(input.path(), mesh_, options, std::move(format));
  }

 private:
  const PlyElement& vertex_element(const ScanInput& input) const {
    const PlyElement* const vertex = header_.find("vertex");
    if (vertex == nullptr) input.fail("has no element \"vertex\".");
    return *vertex;
  }

  void read_element(const PlyElement& element) {
    if (&element == &vertex_) {
      read_vertex();
    } else {
      pass_over(element, is_mesh_ ? vertex_list(element) : -1);
    }
  }

  void read_vertex() {
    std::array<double, 6> numbers{};
    for (int k = 0; k < int(vertex_.properties.size()); ++k) {
      const PlyProperty& property = vertex_.properties[k];
      if (property.length_type) {
        pass_list(property);
        continue;
      }
      const double value = values_.next(property.type);
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (columns_[c] == k) numbers[c] = value;
      }
    }
    const Eigen::Vector3d point(numbers[0], numbers[1], numbers[2]);
    if (is_mesh_) {
      mesh_.points.push_back(point);
    } else {
      collector_.add(point, {numbers[3], numbers[4], numbers[5]});
    }
  }

  // Reads an element without keeping more than the triangles of property `faces`.
  void pass_over(const PlyElement& element, int faces) {
    for (int k = 0; k < int(element.properties.size()); ++k) {
      const PlyProperty& property = element.properties[k];
      if (k == faces) {
        read_face(property);
      } else if (property.length_type) {
        pass_list(property);
      } else {
        values_.next(property.type);
      }
    }
  }

  void pass_list(const PlyProperty& property) {
    for (std::uint64_t left = values_.next_length(*property.length_type); left > 0; --left) {
      values_.next(property.type);
    }
  }

  // A polygon becomes a fan of triangles.
  void read_face(const PlyProperty& property) {
    const std::uint64_t corners = values_.next_length(*property.length_type);
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint64_t k = 0; k < corners; ++k) {
      triangle[1] = triangle[2];
      triangle[2] = vertex_index(values_.next(property.type));
      if (k == 0) triangle[0] = triangle[2];
      if (k >= 2) add_triangle(triangle);
    }
  }

  void add_triangle(const std::array<std::uint32_t, 3>& triangle) {
    if (mesh_.triangles.size() == most_triangles) {
      values_.fail(fmt::format("the mesh has more than {} triangles.", most_triangles));
    }
    mesh_.triangles.push_back(triangle);
  }

  std::uint32_t vertex_index(double value) const {
    if (!(value >= 0.0 && value < double(vertex_.count) && value == std::floor(value))) {
      values_.fail(fmt::format("a face uses vertex {}, but there are {}, counted from 0.", value,
                               vertex_.count));
    }
    return static_cast<std::uint32_t>(value);
  }

  const PlyHeader& header_;
  const PlyElement& vertex_;
  PointColumns columns_;
  PlyValues values_;
  ScanCollector collector_;
  ScanMesh mesh_;
  bool is_mesh_ = false;
};

std::string format_text(const PlyHeader& header) {
  if (header.ascii) return "PLY, ASCII";
  return header.order == ByteOrder::big ? "PLY, binary big endian" : "PLY, binary little endian";
}

}  // namespace

ScanFile read_scan_ply(const std::filesystem::path& path, const ReadScanOptions& options) {
  ScanInput input(path);
  const PlyHeader header = read_ply_header(input);
  return PlyReader(input, header, options).read(input, options, format_text(header));
}

}  // namespace bodyline::io
