#include "io/read_scan_stl.hpp"

#include <fmt/format.h>

#include "io/scalar_type.hpp"
#include "io/scan_input.hpp"
#include "io/scan_mesh.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t head = 80, count_size = 4, facet_size = 50;

// Vertices come in threes, each triangle with its own.
void close_triangle(const ScanInput& input, ScanMesh& mesh) {
  if (mesh.triangles.size() == most_triangles) {
    input.fail(fmt::format("has more than {} triangles.", most_triangles));
  }
  const auto end = static_cast<std::uint32_t>(mesh.points.size());
  mesh.triangles.push_back({end - 3, end - 2, end - 1});
}

void read_binary(ScanInput& input, ScanMesh& mesh) {
  const char* const count_bytes = input.bytes(head + count_size);
  if (count_bytes == nullptr) input.fail("is cut off: an STL file has 84 bytes or more.");
  const double count = scalar_from_bytes(count_bytes + head, ScalarType::uint32, ByteOrder::little);
  for (double k = 0; k < count; ++k) {
    const char* const facet = input.bytes(facet_size);
    if (facet == nullptr) {
      input.fail(fmt::format("is cut off: it ends after {} of {} triangles.", k, count));
    }
    for (int corner = 1; corner <= 3; ++corner) {  // the first three numbers are the normal
      Eigen::Vector3d point;
      for (int c = 0; c < 3; ++c) {
        point[c] =
            scalar_from_bytes(facet + 12 * corner + 4 * c, ScalarType::float32, ByteOrder::little);
      }
      mesh.points.push_back(point);
    }
    close_triangle(input, mesh);
  }
}

std::string lower_case(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Eigen::Vector3d point_from_words(const ScanInput& input, std::string_view words) {
  Eigen::Vector3d point;
  for (int c = 0; c < 3; ++c) {
    const std::string_view word = next_word(words);
    if (!number_from_word(word, point[c])) {
      input.fail_line(shown_word(word) + " is not a coordinate of a vertex.");
    }
  }
  return point;
}

void close_loop(const ScanInput& input, ScanMesh& mesh) {
  if (mesh.points.size() != 3 * (mesh.triangles.size() + 1)) {
    input.fail_line("a loop ends that does not have three vertices.");
  }
  close_triangle(input, mesh);
}

void read_ascii(ScanInput& input, ScanMesh& mesh) {
  std::string_view line;
  bool ended = false;
  while (input.filled_line(line)) {
    const std::string keyword = lower_case(next_word(line));
    ended = keyword == "endsolid" || keyword == "end";
    if (keyword == "vertex") {
      mesh.points.push_back(point_from_words(input, line));
    } else if (keyword == "endloop") {
      close_loop(input, mesh);
    } else if (!ended && keyword != "solid" && keyword != "facet" && keyword != "outer" &&
               keyword != "endfacet") {
      input.fail_line(shown_word(keyword) + " is not known in an STL file.");
    }
  }
  if (!ended) input.fail_line("is cut off: an STL file in ASCII ends with \"endsolid\".");
}

// Binary files may begin with "solid" too; their size tells them apart.
bool is_ascii(const std::filesystem::path& path) {
  ScanInput input(path);
  const char* const bytes = input.bytes(head + count_size);
  if (bytes != nullptr) {
    const double count = scalar_from_bytes(bytes + head, ScalarType::uint32, ByteOrder::little);
    if (head + count_size + facet_size * count == double(input.size())) return false;
  }
  ScanInput text(path);
  const char* const word = text.bytes(5);
  return word != nullptr && lower_case({word, 5}) == "solid";
}

}  // namespace

ScanFile read_scan_stl(const std::filesystem::path& path, const ReadScanOptions& options) {
  const bool ascii = is_ascii(path);
  ScanInput input(path);
  ScanMesh mesh;
  if (ascii) {
    read_ascii(input, mesh);
  } else {
    read_binary(input, mesh);
  }
  return scan_from_mesh(path, mesh, options, ascii ? "STL, ASCII" : "STL, binary");
}

}  // namespace bodyline::io
