#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/scan.hpp"

namespace bodyline::optimize {

/// Finds near points that are turned alike: points of six coordinates, positions and normals times
/// a length.
class OrientedTree {
 public:
  using Key = std::array<double, 6>;
  explicit OrientedTree(std::vector<Key> keys);
  ~OrientedTree();

  /// Indices of the nearest keys, nearest first; fills `found` or as much of it as there are keys,
  /// returns how many: none near a key that is not finite. Safe to call from several threads at
  /// once.
  std::size_t nearest(const Key& key, std::span<std::size_t> found) const;
  /// The nearest key; nothing where the key is not finite or the tree is empty.
  std::optional<std::size_t> nearest_one(const Key& key) const;

  /// The key of a position and a normal (zero where there is none).
  static Key key(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, double length) {
    return {position.x(),        position.y(),        position.z(),
            length * normal.x(), length * normal.y(), length * normal.z()};
  }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
