#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace bodyline::explore {

/// What HDF5 writes for an address that is none.
inline constexpr std::uint64_t no_address = ~std::uint64_t(0);

/// The index of a dataset's chunks, a B-tree of version 1 as section III.A.1 of the "HDF5 File
/// Format Specification, Version 2.0" has it, to which chunks are only appended. What is in the
/// file is never overwritten: the nodes on the way to the last chunk are written anew, behind
/// everything else, and whoever still reads the old root sees the old tree, whole.
class ChunkTree {
 public:
  /// `chunk` is the shape of a chunk, rows first. Chunks hold whole rows.
  ChunkTree(std::vector<std::uint64_t> chunk, std::size_t element_bytes);

  /// Gives `count` bytes of the file at an address.
  using Read = std::function<std::vector<std::byte>(std::uint64_t address, std::size_t count)>;

  /// Takes over the tree at `root` up to the chunk before `rows`; later ones are dropped. Throws
  /// std::runtime_error when what is there is no such tree.
  void load(std::uint64_t root, std::uint64_t rows, const Read& read);

  /// Adds the chunk whose first row is `row`; it replaces the last one when that begins there too.
  void append(std::uint64_t row, std::uint32_t bytes, std::uint64_t address);

  /// The nodes that changed since, to be written from the address `at` on (a multiple of 8), and
  /// where the root then is; `no_address` without chunks.
  struct Image {
    std::vector<std::byte> bytes;
    std::uint64_t root = no_address;
    /// Addresses that become right once the new root is in place: (where to write, address).
    std::vector<std::pair<std::uint64_t, std::uint64_t>> patches;
  };
  Image write(std::uint64_t at);

 private:
  struct Child {
    std::uint64_t row = 0;
    std::uint32_t bytes = 0;  // of the chunk that begins there
    std::uint64_t address = no_address;
  };
  // The last node of a level; those before it are full and have been written for good.
  struct Node {
    std::vector<Child> children;
    std::uint64_t left = no_address;
  };

  std::size_t key_bytes() const;
  std::size_t node_bytes() const;
  void add(std::size_t level, const Child& child, std::uint64_t at, Image& image);
  std::uint64_t emit(std::size_t level, const Child* next, std::uint64_t at, Image& image) const;
  Node decoded(const std::vector<std::byte>& bytes, std::size_t level) const;

  std::vector<std::uint64_t> chunk_;
  std::size_t element_bytes_;
  std::vector<Node> levels_;     // leaf first
  std::vector<Child> appended_;  // since the last write
};

}  // namespace bodyline::explore
