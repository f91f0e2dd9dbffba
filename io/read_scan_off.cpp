#include "io/read_scan_off.hpp"

#include <fmt/format.h>

#include "io/scan_collector.hpp"
#include "io/scan_input.hpp"
#include "io/scan_mesh.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

class OffReader {
 public:
  explicit OffReader(const std::filesystem::path& path) : input_(path) {}

  ScanFile read(const ReadScanOptions& options) {
    read_counts();
    for (std::uint64_t k = 0; k < vertices_; ++k) read_vertex(k);
    for (std::uint64_t k = 0; k < faces_; ++k) read_face(k);
    if (faces_ > 0) return scan_from_mesh(input_.path(), mesh_, options, "OFF");
    ScanCollector collector(options);
    for (const Eigen::Vector3d& point : mesh_.points) collector.add(point);
    return collector.finish("OFF");
  }

 private:
  // The next line that holds anything but a comment.
  bool next_line(std::string_view& line) {
    while (input_.line(line)) {
      line = line.substr(0, line.find('#'));
      std::string_view words = line;
      if (!next_word(words).empty()) return true;
    }
    return false;
  }

  // Counts of vertices, faces and edges, behind the word OFF on its own line or on the same.
  void read_counts() {
    std::string_view line;
    if (!next_line(line)) input_.fail("is not an OFF file: there is nothing in it.");
    std::string_view words = line;
    if (next_word(words).ends_with("OFF")) {
      line = words;
      if (next_word(words).empty() && !next_line(line))
        input_.fail("is cut off: it has no counts.");
    }
    if (!whole_from_word(next_word(line), vertices_) || !whole_from_word(next_word(line), faces_)) {
      input_.fail_line("is not an OFF file in text: there are no counts of vertices and faces.");
    }
    if (std::max(vertices_, faces_) > most_triangles) {
      input_.fail_line(fmt::format("announces more than {} vertices or faces.", most_triangles));
    }
  }

  void read_vertex(std::uint64_t k) {
    std::string_view line;
    if (!next_line(line)) {
      input_.fail(fmt::format("is cut off: it ends after {} of {} vertices.", k, vertices_));
    }
    Eigen::Vector3d point;
    for (int c = 0; c < 3; ++c) {
      const std::string_view word = next_word(line);
      if (!number_from_word(word, point[c])) {
        input_.fail_line(shown_word(word) + " is not a coordinate of a vertex.");
      }
    }
    mesh_.points.push_back(point);
  }

  void read_face(std::uint64_t k) {
    std::string_view line;
    if (!next_line(line)) {
      input_.fail(fmt::format("is cut off: it ends after {} of {} faces.", k, faces_));
    }
    std::size_t corners = 0;
    if (!whole_from_word(next_word(line), corners)) {
      input_.fail_line("a face does not begin with the number of its vertices.");
    }
    polygon_.clear();
    for (std::size_t corner = 0; corner < corners; ++corner) {
      const std::string_view word = next_word(line);
      std::uint32_t index = 0;
      if (!whole_from_word(word, index) || index >= vertices_) {
        input_.fail_line(fmt::format("a face uses vertex {}, but there are {}, counted from 0.",
                                     shown_word(word), vertices_));
      }
      polygon_.push_back(index);
    }
    if (!append_polygon(mesh_, polygon_)) {
      input_.fail_line(fmt::format("the mesh has more than {} triangles.", most_triangles));
    }
  }

  ScanInput input_;
  std::uint64_t vertices_ = 0, faces_ = 0;
  ScanMesh mesh_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

ScanFile read_scan_off(const std::filesystem::path& path, const ReadScanOptions& options) {
  return OffReader(path).read(options);
}

}  // namespace bodyline::io
