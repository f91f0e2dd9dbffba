#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "explore/append_file.hpp"
#include "explore/block_codec.hpp"
#include "explore/chunk_tree.hpp"
#include "explore/store_reader.hpp"

namespace bodyline::explore {

/// A store's file in the hands of its writer: blocks go behind its end, and a commit makes them
/// part of it, step by step so that it is a whole HDF5 file after each (docs/store.md).
class StoreFile {
 public:
  /// `reader` has the same file open, and is not needed afterwards.
  StoreFile(std::unique_ptr<AppendFile> file, const StoreReader& reader);

  /// Writes the chunks of a block; of a block that was written before with fewer rows, those that
  /// were not full; nothing of one that has no new rows.
  void write(const EncodedBlock& block);
  /// Makes all written blocks part of the store, which then has so many rows.
  void commit(std::uint64_t rows);
  /// Gives up what was written since the last commit.
  void drop_unfinished() { file_->drop_unfinished(); }

 private:
  struct Table {
    ChunkTree tree;
    DatasetPlaces places;
    int chunk_rows = 1;
  };
  std::unique_ptr<AppendFile> file_;
  std::uint64_t counter_ = 0;  // its address
  std::vector<Table> tables_;
  std::uint64_t written_ = 0;  // rows
};

}  // namespace bodyline::explore
