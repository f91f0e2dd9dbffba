#pragma once

#include <cstddef>
#include <vector>

#include "explore/store_layout.hpp"

namespace bodyline::explore {

/// A block of rows as its chunks stand in the file.
struct EncodedBlock {
  std::uint64_t first = 0;
  int rows = 0;
  /// Of each table of the layout, in order, its chunks.
  std::vector<std::vector<std::vector<std::byte>>> chunks;
};

/// Shuffles and compresses, where the layout asks for it, as HDF5's filters `shuffle` and `deflate`
/// undo it. `rows.first` is a multiple of the block; a last block with fewer rows is filled up with
/// zeros. Safe to call from several threads.
EncodedBlock encode_block(const StoreLayout& layout, const VariantRows& rows);

}  // namespace bodyline::explore
