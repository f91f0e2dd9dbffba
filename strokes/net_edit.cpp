#include "strokes/net_edit.hpp"

namespace bodyline::strokes {
namespace {

// Keeps what was there before the first change; what was added needs no keeping.
template <class Part>
Part& changeable(std::vector<Part>& parts, std::size_t count_before, std::map<int, Part>& old,
                 int index) {
  if (static_cast<std::size_t>(index) < count_before) old.try_emplace(index, parts[index]);
  return parts[index];
}

template <class Part>
void undo(std::vector<Part>& parts, std::size_t count_before, std::map<int, Part>& old) {
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(count_before), parts.end());
  for (auto& [index, part] : old) parts[index] = std::move(part);
}

template <class Part>
std::set<int> changed(const std::vector<Part>& parts, std::size_t count_before,
                      const std::map<int, Part>& old) {
  std::set<int> indices;
  for (const auto& [index, part] : old) indices.insert(index);
  for (std::size_t k = count_before; k < parts.size(); ++k) indices.insert(static_cast<int>(k));
  return indices;
}

}  // namespace

NetEdit::NetEdit(Net& net)
    : net_(net),
      vertices_(net.vertices.size()),
      edges_(net.edges.size()),
      patches_(net.patches.size()) {}

NetEdit::~NetEdit() {
  if (committed_) return;
  undo(net_.vertices, vertices_, old_vertices_);
  undo(net_.edges, edges_, old_edges_);
  undo(net_.patches, patches_, old_patches_);
}

Vertex& NetEdit::vertex(int index) {
  return changeable(net_.vertices, vertices_, old_vertices_, index);
}

Edge& NetEdit::edge(int index) { return changeable(net_.edges, edges_, old_edges_, index); }

Patch& NetEdit::patch(int index) { return changeable(net_.patches, patches_, old_patches_, index); }

int NetEdit::add_vertex(Vertex vertex) {
  net_.vertices.push_back(std::move(vertex));
  return static_cast<int>(net_.vertices.size()) - 1;
}

int NetEdit::add_edge(Edge edge) {
  const int index = static_cast<int>(net_.edges.size());
  for (const int end : {edge.start, edge.end}) vertex(end).edges.push_back(index);
  net_.edges.push_back(std::move(edge));
  return index;
}

int NetEdit::add_patch(Patch patch) {
  net_.patches.push_back(std::move(patch));
  return static_cast<int>(net_.patches.size()) - 1;
}

std::set<int> NetEdit::moved_edges() const {
  std::set<int> edges = changed(net_.edges, edges_, old_edges_);
  for (const auto& [index, old] : old_edges_)
    if (net_.edges[index].curve == old.curve) edges.erase(index);
  return edges;
}

std::set<int> NetEdit::changed_patches() const {
  return changed(net_.patches, patches_, old_patches_);
}

}  // namespace bodyline::strokes
