#include "strokes/surface_index.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

#include "strokes/patch_map.hpp"

namespace bodyline::strokes {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using Entry = std::pair<TreeBox, int>;
using Tree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

TreePoint tree_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

TreeBox box_around(const std::vector<Eigen::Vector3d>& points, double margin) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  const Eigen::Vector3d wide = Eigen::Vector3d::Constant(margin);
  return {tree_point(box.min() - wide), tree_point(box.max() + wide)};
}

// Replaces the entry of a part; boxes[index] is what the tree holds of it.
void enter(Tree& tree, std::vector<TreeBox>& boxes, int index, const TreeBox& box) {
  if (static_cast<std::size_t>(index) < boxes.size()) {
    tree.remove({boxes[index], index});
  } else {
    boxes.resize(index + 1);
  }
  boxes[index] = box;
  tree.insert({box, index});
}

}  // namespace

struct SurfaceIndex::Trees {
  Tree patches, edges;
  std::vector<TreeBox> patch_boxes, edge_boxes;
  std::vector<Facets> facets;  // by patch

  void enter_patch(const Net& net, int patch) {
    if (facets.size() <= static_cast<std::size_t>(patch)) facets.resize(patch + 1);
    facets[patch] = make_facets(*net.patches[patch].shape);
    enter(patches, patch_boxes, patch, box_around(facets[patch].points, facets[patch].sag));
  }
  FootPoint foot_on(const Net& net, int patch, const Eigen::Vector3d& point) const {
    const PatchShape& shape = *net.patches[patch].shape;
    const PatchFoot foot = refined_foot(shape, nearest_facet(facets[patch], point).st, point);
    return {patch, foot.st, to_domain(shape.corners(), foot.st), foot.point, foot.distance};
  }
  bool is_farther(int patch, const Eigen::Vector3d& point, double distance) const {
    return nearest_facet(facets[patch], point).distance - facets[patch].sag > distance;
  }
  /// Patches whose boxes are within a distance of a point, the nearest first.
  std::vector<std::pair<double, int>> patches_within(const Eigen::Vector3d& point,
                                                     double distance) const {
    std::vector<std::pair<double, int>> near;
    for (auto entry = patches.qbegin(bg::index::intersects(box_around({point}, distance)));
         entry != patches.qend(); ++entry)
      near.emplace_back(bg::distance(tree_point(point), entry->first), entry->second);
    std::sort(near.begin(), near.end());
    return near;
  }
  void enter_edge(const Net& net, int edge) {
    enter(edges, edge_boxes, edge, box_around(net.edges[edge].curve.points, 0.0));
  }
};

SurfaceIndex::SurfaceIndex(const Net& net) : trees_(std::make_unique<Trees>()) {
  for (int k = 0; k < static_cast<int>(net.patches.size()); ++k) trees_->enter_patch(net, k);
  for (int k = 0; k < static_cast<int>(net.edges.size()); ++k) trees_->enter_edge(net, k);
}

SurfaceIndex::~SurfaceIndex() = default;
SurfaceIndex::SurfaceIndex(SurfaceIndex&&) noexcept = default;
SurfaceIndex& SurfaceIndex::operator=(SurfaceIndex&&) noexcept = default;

void SurfaceIndex::update(const Net& net, const std::set<int>& patches,
                          const std::set<int>& edges) {
  for (const int patch : patches) trees_->enter_patch(net, patch);
  for (const int edge : edges) trees_->enter_edge(net, edge);
}

std::optional<FootPoint> SurfaceIndex::foot_point(const Net& net,
                                                  const Eigen::Vector3d& point) const {
  if (!point.allFinite()) return std::nullopt;
  // The foot on the patch with the nearest box bounds the search for a nearer one.
  FootPoint best;
  for (auto entry = trees_->patches.qbegin(bg::index::nearest(tree_point(point), 1));
       entry != trees_->patches.qend(); ++entry)
    best = trees_->foot_on(net, entry->second, point);
  for (const auto& [box_distance, patch] : trees_->patches_within(point, best.distance)) {
    if (box_distance > best.distance) break;
    if (patch == best.patch || trees_->is_farther(patch, point, best.distance)) continue;
    const FootPoint foot = trees_->foot_on(net, patch, point);
    // Of patches that meet there the first in number, so that the order of a tree does not show.
    if (foot.distance < best.distance || (foot.distance == best.distance && patch < best.patch))
      best = foot;
  }
  if (!std::isfinite(best.distance)) return std::nullopt;
  return best;
}

std::vector<int> SurfaceIndex::edges_near(const std::vector<Eigen::Vector3d>& points,
                                          double distance) const {
  std::vector<int> edges;
  for (auto entry = trees_->edges.qbegin(bg::index::intersects(box_around(points, distance)));
       entry != trees_->edges.qend(); ++entry)
    edges.push_back(entry->second);
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace bodyline::strokes
