#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/read_strokes_formats.hpp"
#include "io/scan_input.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

/// A polyline by the numbers of its vertices, from 0, and the group that it is in.
struct Path {
  std::string group;
  std::vector<long> vertices;
};

std::string rest_of(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  const std::size_t end = line.find_last_not_of(" \t\r");
  return begin == line.npos ? "" : std::string(line.substr(begin, end - begin + 1));
}

/// The statements of an OBJ file that matter here.
class ObjFile {
 public:
  explicit ObjFile(const std::filesystem::path& path) : input_(path) {
    std::string_view line;
    std::string statement;
    while (input_.line(line)) {
      const std::size_t end = line.find_last_not_of(" \t\r");
      const bool goes_on = end != line.npos && line[end] == '\\';
      statement += goes_on ? line.substr(0, end) : line;
      if (goes_on) continue;
      read(statement);
      statement.clear();
    }
    read(statement);
  }

  std::vector<Eigen::Vector3d> vertices;
  std::vector<Path> paths;

 private:
  void read(std::string_view statement) {
    const std::string_view word = next_word(statement);
    if (word == "v") {
      vertices.push_back(vertex(statement));
    } else if (word == "l") {
      paths.push_back({group_, indices(statement)});
    } else if (word == "o" || word == "g") {
      group_ = rest_of(statement);
    }
  }
  Eigen::Vector3d vertex(std::string_view words) {
    Eigen::Vector3d point;
    for (double& coordinate : point) {
      const std::string_view word = next_word(words);
      if (word.empty() || !number_from_word(word, coordinate))
        input_.fail_line(fmt::format("{} is no coordinate of a vertex.", shown_word(word)));
    }
    return point;
  }
  // Numbers count from 1, or back from the last vertex when negative; what follows a slash is no
  // concern here.
  std::vector<long> indices(std::string_view words) {
    std::vector<long> result;
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
      long index = 0;
      const auto count = static_cast<long>(vertices.size());
      if (!whole_from_word(word.substr(0, word.find('/')), index) || index == 0 || index > count ||
          index < -count)
        input_.fail_line(fmt::format("{} is no vertex of the file so far.", shown_word(word)));
      result.push_back(index > 0 ? index - 1 : count + index);
    }
    if (result.size() < 2) input_.fail_line("a line takes two vertices or more.");
    return result;
  }

  ScanInput input_;
  std::string group_;
};

bool is_segment(const Path& path) { return path.vertices.size() == 2; }

/// Some programs write every segment of a curve as a line of its own; those of a group that hang
/// together in a chain are one stroke.
class SegmentChains {
 public:
  explicit SegmentChains(const std::vector<Path>& paths) : paths_(paths), used_(paths.size()) {
    for (std::size_t k = 0; k < paths.size(); ++k)
      if (is_segment(paths[k]))
        for (const long vertex : paths[k].vertices) at_[{paths[k].group, vertex}].push_back(k);
  }

  std::vector<Path> run() {
    std::vector<Path> chains;
    for (const bool from_ends : {true, false}) {  // what is left after the open chains is closed
      for (std::size_t k = 0; k < paths_.size(); ++k) {
        if (used_[k]) continue;
        const Path& path = paths_[k];
        if (!is_segment(path)) {
          used_[k] = true;
          first_.push_back(k);
          chains.push_back(path);
          continue;
        }
        const bool begins = ends_at(path, 0), finishes = ends_at(path, 1);
        if (from_ends && !begins && !finishes) continue;
        first_.push_back(k);
        chains.push_back(follow(k, from_ends && !begins));
      }
    }
    return in_order(std::move(chains));
  }

 private:
  // Whether no single other segment goes on at an end.
  bool ends_at(const Path& path, int end) const {
    return at_.at({path.group, path.vertices[end]}).size() != 2;
  }
  Path follow(std::size_t segment, bool backwards) {
    Path chain = paths_[segment];
    if (backwards) std::reverse(chain.vertices.begin(), chain.vertices.end());
    used_[segment] = true;
    while (true) {
      const auto& here = at_.at({chain.group, chain.vertices.back()});
      if (here.size() != 2) break;
      const auto next =
          std::find_if(here.begin(), here.end(), [&](std::size_t k) { return !used_[k]; });
      if (next == here.end()) break;
      used_[*next] = true;
      const auto& ends = paths_[*next].vertices;
      chain.vertices.push_back(ends[0] == chain.vertices.back() ? ends[1] : ends[0]);
    }
    return chain;
  }
  // By the first statement of each.
  std::vector<Path> in_order(std::vector<Path> chains) const {
    std::vector<std::size_t> order(chains.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return first_[a] < first_[b]; });
    std::vector<Path> sorted;
    for (const std::size_t k : order) sorted.push_back(std::move(chains[k]));
    return sorted;
  }

  const std::vector<Path>& paths_;
  std::vector<bool> used_;
  std::vector<std::size_t> first_;
  std::map<std::pair<std::string, long>, std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<model::Stroke> read_strokes_obj(const std::filesystem::path& path) {
  const ObjFile file(path);
  std::vector<model::Stroke> strokes;
  for (const Path& chain : SegmentChains(file.paths).run()) {
    model::Stroke stroke{chain.group, {}};
    for (const long vertex : chain.vertices) stroke.points.push_back(file.vertices[vertex]);
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace bodyline::io
