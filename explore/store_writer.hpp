#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "explore/block_codec.hpp"
#include "explore/store_error.hpp"
#include "explore/store_layout.hpp"
#include "explore/variant_rows.hpp"

namespace bodyline::explore {

struct StoreOptions {
  double commit_seconds = 1.0;  ///< finished blocks wait no longer than this for the disk
  bool merged = false;          ///< rows of several stores; such a store is never gone on with
};

/// The one writer of a store (docs/store.md). Whatever ends the program, the file can be opened by
/// any HDF5 reader and holds all rows that were committed. All functions throw StoreError with one
/// sentence: file in use by another writer, disk full, not a store. Not for two threads at once.
class StoreWriter {
 public:
  /// A new store for `planned` rows, whose name must be free unless `overwrite`.
  static StoreWriter create(const std::filesystem::path& path, const Study& study,
                            const DesignSpace& space, std::uint64_t planned, bool overwrite,
                            const StoreOptions& options = {});
  /// Goes on with a store of the same study; not with one whose rows are of several.
  static StoreWriter resume(const std::filesystem::path& path, const Study& study,
                            const StoreOptions& options = {});
  ~StoreWriter();
  StoreWriter(StoreWriter&&) noexcept;

  const StoreLayout& layout() const;
  /// Rows that are safe on the disk.
  std::uint64_t committed_rows() const;
  /// Rows committed, and appended since.
  std::uint64_t rows() const;

  /// Appends rows, `rows.first` == rows(). For those who have few at a time.
  void append(const VariantRows& rows);
  /// Hands the rows of an incomplete block to the disk too, for those who have few in a long time.
  void flush();

  /// Takes away the rows of the last, incomplete block, for those who append whole blocks: they
  /// begin with these again.
  VariantRows take_incomplete_block();
  /// Appends whole blocks made by encode_block; only the last of a store may be shorter. Returns at
  /// once unless many wait: a thread of the writer's own writes and commits.
  void append(EncodedBlock block);

  /// Commits everything and ends the writing. Without it, only what was committed before is kept.
  void finish();

 private:
  struct State;
  explicit StoreWriter(std::unique_ptr<State> state);
  static StoreWriter open(const std::filesystem::path& path, const Study& study,
                          const StoreOptions& options);
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
