#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "explore/dataset_places.hpp"
#include "explore/store_error.hpp"
#include "explore/store_layout.hpp"
#include "explore/study.hpp"

namespace bodyline::explore {

/// What a store says about itself.
struct StoreHeader {
  std::string version;              ///< of the program that made it
  std::uint64_t rows = 0;           ///< committed
  std::uint64_t planned = 0;        ///< of the whole study
  bool merged = false;              ///< its rows are of several stores
  std::vector<StudyInput> inputs;   ///< as in Study
  std::vector<MeasuredFile> files;  ///< likewise
  std::vector<std::string> causes;  ///< what a Cause counts
};

/// Reads a store, also one that is being written: it sees the rows that were committed when it was
/// opened. Throws StoreError with one sentence for what is not a store, is cut off or damaged. One
/// thread at a time may use any of these.
class StoreReader {
 public:
  explicit StoreReader(const std::filesystem::path& path);
  ~StoreReader();
  StoreReader(StoreReader&&) noexcept;

  const std::filesystem::path& path() const;
  const StoreHeader& header() const;
  std::uint64_t rows() const { return header().rows; }
  /// The study, made from the texts in the store.
  const Study& study() const;
  const DesignSpace& space() const;
  const StoreLayout& layout() const;

  /// Rows first to first + count - 1. Without `pictures`, nets and thumbnails stay empty.
  VariantRows read(std::uint64_t first, int count, bool pictures = false) const;

  /// Where in the file the numbers stand that grow with it: the committed rows, and for each table
  /// of the layout its own. Throws StoreError when they cannot be replaced.
  struct Places {
    std::uint64_t counter = 0;
    std::vector<DatasetPlaces> tables;
  };
  Places places() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
