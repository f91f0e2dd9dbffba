#include "explore/chunk_tree.hpp"

#include <cstring>
#include <stdexcept>

#include "explore/little_endian.hpp"

namespace bodyline::explore {
namespace {

constexpr std::size_t most_children = 64;  // twice the K that a superblock of version 0 implies
constexpr char signature[] = {'T', 'R', 'E', 'E'};
constexpr int chunk_node_type = 1;
// Where a node's parts stand.
constexpr std::size_t type_at = 4, level_at = 5, count_at = 6, left_at = 8, right_at = 16,
                      keys_at = 24;
constexpr std::size_t address_bytes = 8;

}  // namespace

ChunkTree::ChunkTree(std::vector<std::uint64_t> chunk, std::size_t element_bytes)
    : chunk_(std::move(chunk)), element_bytes_(element_bytes) {}

// Size and filter mask of a chunk, then its place in all dimensions and in the element.
std::size_t ChunkTree::key_bytes() const { return 4 + 4 + 8 * (chunk_.size() + 1); }

std::size_t ChunkTree::node_bytes() const {
  return keys_at + most_children * address_bytes + (most_children + 1) * key_bytes();
}

void ChunkTree::append(std::uint64_t row, std::uint32_t bytes, std::uint64_t address) {
  appended_.push_back({row, bytes, address});
}

// Puts the last node of a level into the image and returns its address. `next` is the first child
// of the node to its right, null when there is none.
std::uint64_t ChunkTree::emit(std::size_t level, const Child* next, std::uint64_t at,
                              Image& image) const {
  const Node& node = levels_[level];
  const std::size_t first = image.bytes.size();
  const std::uint64_t address = at + first;
  image.bytes.resize(first + (node_bytes() + 7) / 8 * 8);
  std::byte* const out = image.bytes.data() + first;
  std::memcpy(out, signature, sizeof signature);
  out[type_at] = std::byte(chunk_node_type);
  out[level_at] = std::byte(level);
  put_little_endian(out + count_at, node.children.size(), 2);
  put_little_endian(out + left_at, node.left, 8);
  put_little_endian(out + right_at, no_address, 8);
  std::byte* key = out + keys_at;
  for (const Child& child : node.children) {
    put_little_endian(key, child.bytes, 4);
    put_little_endian(key + 8, child.row, 8);
    put_little_endian(key + key_bytes(), child.address, 8);
    key += key_bytes() + address_bytes;
  }
  if (next != nullptr) {
    put_little_endian(key, next->bytes, 4);
    put_little_endian(key + 8, next->row, 8);
  } else {  // just behind the last chunk in every dimension
    put_little_endian(key + 8, levels_.front().children.back().row + chunk_.front(), 8);
    for (std::size_t d = 1; d < chunk_.size(); ++d)
      put_little_endian(key + 8 + 8 * d, chunk_[d], 8);
    put_little_endian(key + 8 + 8 * chunk_.size(), element_bytes_, 8);
  }
  if (node.left != no_address) image.patches.emplace_back(node.left + right_at, address);
  return address;
}

void ChunkTree::add(std::size_t level, const Child& child, std::uint64_t at, Image& image) {
  if (level == levels_.size()) levels_.emplace_back();
  if (levels_[level].children.size() == most_children) {
    const std::uint64_t address = emit(level, &child, at, image);
    if (level + 1 == levels_.size()) {
      const Child first = levels_[level].children.front();
      levels_.emplace_back();
      levels_.back().children.push_back(first);
    }
    levels_[level + 1].children.back().address = address;
    add(level + 1, {child.row, child.bytes, no_address}, at, image);
    levels_[level] = {{}, address};
  }
  levels_[level].children.push_back(child);
}

ChunkTree::Image ChunkTree::write(std::uint64_t at) {
  Image image;
  for (const Child& child : appended_) {
    if (!levels_.empty() && levels_.front().children.back().row == child.row) {
      levels_.front().children.back() = child;
    } else {
      add(0, child, at, image);
    }
  }
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    image.root = emit(level, nullptr, at, image);
    if (level + 1 < levels_.size()) levels_[level + 1].children.back().address = image.root;
  }
  appended_.clear();
  return image;
}

ChunkTree::Node ChunkTree::decoded(const std::vector<std::byte>& bytes, std::size_t level) const {
  const std::size_t count = get_little_endian(bytes.data() + count_at, 2);
  if (std::memcmp(bytes.data(), signature, sizeof signature) != 0 ||
      bytes[type_at] != std::byte(chunk_node_type) || bytes[level_at] != std::byte(level) ||
      count > most_children) {
    throw std::runtime_error("the index of its chunks is damaged");
  }
  Node node;
  node.left = get_little_endian(bytes.data() + left_at, 8);
  const std::byte* key = bytes.data() + keys_at;
  for (std::size_t k = 0; k < count; ++k, key += key_bytes() + address_bytes) {
    node.children.push_back({get_little_endian(key + 8, 8),
                             std::uint32_t(get_little_endian(key, 4)),
                             get_little_endian(key + key_bytes(), 8)});
  }
  return node;
}

void ChunkTree::load(std::uint64_t root, std::uint64_t rows, const Read& read) {
  levels_.clear();
  appended_.clear();
  if (root == no_address || rows == 0) return;
  const std::size_t depth = std::size_t(read(root, node_bytes())[level_at]);
  levels_.resize(depth + 1);
  std::uint64_t address = root;
  for (std::size_t level = depth + 1; level-- > 0;) {
    Node& node = levels_[level];
    node = decoded(read(address, node_bytes()), level);
    while (!node.children.empty() && node.children.back().row >= rows) node.children.pop_back();
    if (node.children.empty()) throw std::runtime_error("the index of its chunks is damaged");
    address = node.children.back().address;
  }
  // A root with one child alone would be allowed, but grows from its child again.
  while (levels_.size() > 1 && levels_.back().children.size() == 1) levels_.pop_back();
}

}  // namespace bodyline::explore
