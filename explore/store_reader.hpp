#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "explore/store_layout.hpp"
#include "explore/study.hpp"

namespace bodyline::explore {

/// What a store says about itself.
struct StoreHeader {
  int schema = 0;
  std::string version;        ///< of the program that made it
  std::uint64_t rows = 0;     ///< committed
  std::uint64_t planned = 0;  ///< of the whole study
  std::vector<StudyInput> inputs;
  std::vector<std::string> causes;
};

/// Reads a store, also one that is being written: it sees the rows that were committed when it was
/// opened. Throws StoreError with one sentence for what is not a store or is damaged.
class StoreReader {
 public:
  explicit StoreReader(const std::filesystem::path& path);
  ~StoreReader();
  StoreReader(StoreReader&&) noexcept;

  const StoreHeader& header() const;
  /// The study, made from the texts in the store.
  const Study& study() const;
  const DesignSpace& space() const;
  const StoreLayout& layout() const;

  /// Rows first to first + count - 1. Without `pictures`, nets and thumbnails stay empty.
  VariantRows read(std::uint64_t first, int count, bool pictures = false) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
