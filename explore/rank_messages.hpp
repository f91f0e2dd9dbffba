#pragma once

#include <string>

#include "explore/ranks.hpp"
#include "explore/store_layout.hpp"
#include "explore/study.hpp"
#include "explore/variant_rows.hpp"

/// What the ranks of a run tell each other. All of them run the same program on alike processors.
namespace bodyline::explore {

enum class RankWord : std::uint8_t {
  ready,    ///< to rank 0: `number` threads wait for work
  rows,     ///< to rank 0: measured
  stopped,  ///< to rank 0: the user wants no more
  failed,   ///< to rank 0: a sentence; this rank takes no more part
  left,     ///< to rank 0: the last word
  measure,  ///< from rank 0: variants first to first + number - 1
  stop      ///< from rank 0: there is no more work
};

/// A message without rows.
struct RankNote {
  RankWord word = RankWord::stop;
  std::uint64_t first = 0;
  int number = 0;
  std::string sentence;
};

RankWord word_of(const Bytes& message);
Bytes note_message(const RankNote& note);
RankNote read_note(const Bytes& message);

/// Measured rows, all tables of the layout.
Bytes rows_message(const StoreLayout& layout, const VariantRows& rows);
std::shared_ptr<VariantRows> read_rows(const StoreLayout& layout, const Bytes& message);

/// The texts of a study with those of its files, and by which instruction set rank 0 measures:
/// bits differ between them. Empty: there is nothing to do.
Bytes study_message(const Study& study);
/// Throws std::runtime_error with one sentence where this rank would measure other bits, and
/// io::InputError.
Study read_study_message(const Bytes& message);

}  // namespace bodyline::explore
