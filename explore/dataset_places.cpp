#include "explore/dataset_places.hpp"

#include <stdexcept>

#include "explore/little_endian.hpp"

namespace bodyline::explore {
namespace {

constexpr std::size_t prefix_bytes = 16, message_prefix_bytes = 8;
constexpr std::uint64_t largest_header = 1 << 20;
constexpr int dataspace_type = 0x01, layout_type = 0x08, continuation_type = 0x10;
constexpr int dataspace_version = 1, layout_version = 3, chunked_class = 2;
// Behind the start of a message's data.
constexpr std::size_t rows_at = 8, root_at = 3;

struct Piece {
  std::uint64_t address, bytes;
};

[[noreturn]] void refuse() {
  throw std::runtime_error("a dataset is not laid out as this program lays them out");
}

}  // namespace

DatasetPlaces dataset_places(
    std::uint64_t header,
    const std::function<std::vector<std::byte>(std::uint64_t, std::size_t)>& read) {
  const std::vector<std::byte> prefix = read(header, prefix_bytes);
  if (prefix[0] != std::byte(1)) refuse();
  DatasetPlaces places;
  std::vector<Piece> pieces{{header + prefix_bytes, get_little_endian(prefix.data() + 8, 4)}};
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Piece piece = pieces[p];
    if (piece.bytes > largest_header) refuse();
    const std::vector<std::byte> bytes = read(piece.address, piece.bytes);
    for (std::size_t at = 0; at + message_prefix_bytes <= bytes.size();) {
      const int type = int(get_little_endian(&bytes[at], 2));
      const std::size_t size = get_little_endian(&bytes[at + 2], 2);
      const std::size_t data = at + message_prefix_bytes;
      if (data + size > bytes.size()) refuse();
      if (type == dataspace_type) {
        if (size < rows_at + 8 || bytes[data] != std::byte(dataspace_version)) refuse();
        places.rows = piece.address + data + rows_at;
      } else if (type == layout_type) {
        if (size < root_at + 8 || bytes[data] != std::byte(layout_version) ||
            bytes[data + 1] != std::byte(chunked_class))
          refuse();
        places.root = piece.address + data + root_at;
      } else if (type == continuation_type) {
        if (size < 16) refuse();
        pieces.push_back(
            {get_little_endian(&bytes[data], 8), get_little_endian(&bytes[data + 8], 8)});
      }
      at = data + size;
    }
  }
  if (places.rows == 0 || places.root == 0) refuse();
  return places;
}

}  // namespace bodyline::explore
