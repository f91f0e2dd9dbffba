#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "model/scan.hpp"

namespace bodyline::optimize {

/// Finds near points that are turned alike: points of six coordinates, positions and normals times
/// a length.
class SearchTree {
 public:
  using Key = std::array<double, 6>;
  explicit SearchTree(std::vector<Key> keys);
  ~SearchTree();

  /// Indices of the nearest keys, nearest first; fills `found` or as much of it as there are keys,
  /// returns how many. Safe to call from several threads at once.
  std::size_t nearest(const Key& key, std::span<std::size_t> found) const;

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
