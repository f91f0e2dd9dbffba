#pragma once

#include <map>
#include <set>

#include "strokes/net.hpp"

namespace bodyline::strokes {

/// Changes to a net that hold together: unless `commit` is called they are undone, bit by bit, when
/// this object goes. Only what is asked for as changeable may be changed.
class NetEdit {
 public:
  explicit NetEdit(Net& net);
  ~NetEdit();
  NetEdit(const NetEdit&) = delete;
  NetEdit& operator=(const NetEdit&) = delete;

  const Net& net() const { return net_; }

  Vertex& vertex(int index);
  Edge& edge(int index);
  Patch& patch(int index);

  int add_vertex(Vertex vertex);
  /// Enters the edge at its two vertices.
  int add_edge(Edge edge);
  int add_patch(Patch patch);

  /// Edges whose curves are new or other than before, and patches changed or added so far.
  std::set<int> moved_edges() const;
  std::set<int> changed_patches() const;

  void commit() { committed_ = true; }

 private:
  Net& net_;
  std::size_t vertices_, edges_, patches_;  // counts before
  std::map<int, Vertex> old_vertices_;
  std::map<int, Edge> old_edges_;
  std::map<int, Patch> old_patches_;
  bool committed_ = false;
};

}  // namespace bodyline::strokes
