#include "io/read_scan_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "io/decimal_commas.hpp"
#include "io/scan_collector.hpp"
#include "io/scan_input.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t most_columns = 16;  // more are not looked at
constexpr int trial_points = 1000;
constexpr double unit_tolerance = 0.02;  // normals are often written with two digits

struct TextRow {
  std::array<double, most_columns> numbers{};
  std::size_t count = 0;  ///< of numbers from the front of the line
  bool only_numbers = true;

  Eigen::Vector3d vector(std::size_t column) const {
    return {numbers[column], numbers[column + 1], numbers[column + 2]};
  }
  /// A lone whole number: how many points follow.
  bool is_count() const {
    return only_numbers && count == 1 && numbers[0] >= 0.0 && numbers[0] == std::floor(numbers[0]);
  }
};

TextRow row_from_line(std::string_view line) {
  TextRow row;
  while (row.count < most_columns) {
    const std::string_view word = next_word(line);
    if (word.empty()) break;
    row.only_numbers = number_from_word(word, row.numbers[row.count]);
    if (!row.only_numbers) break;
    ++row.count;
  }
  return row;
}

bool is_comment(std::string_view line) {
  const std::string_view word = next_word(line);
  return word.empty() || word.starts_with('#') || word.starts_with("//");
}

/// Points of a text file, one after the other.
class TextRows {
 public:
  explicit TextRows(const std::filesystem::path& path)
      : input_(path), counted_(lower_extension(path) == ".pts") {}

  /// False at the end of the file. Throws InputError for a line that holds no point.
  bool next(TextRow& row) {
    std::string_view line;
    while (input_.line(line)) {
      if (is_comment(line)) continue;
      const std::optional<std::string_view> clear = commas_.with_points(line);
      if (!clear) input_.fail_line(unclear_commas(line) + ".");
      row = row_from_line(*clear);
      if (row.count >= 3) {
        ++points_;
        return true;
      }
      if (row.is_count() && (counted_ || points_ == 0)) {
        check_count();
        announced_ += static_cast<std::uint64_t>(std::min(row.numbers[0], 1e18));
      } else if (!is_heading(row)) {
        input_.fail_line(
            fmt::format("{} is no point: it takes three numbers x y z.", shown_word(line)));
      }
    }
    check_count();
    return false;
  }

 private:
  // One line of words may stand above the points.
  bool is_heading(const TextRow& row) {
    if (points_ > 0 || heading_seen_ || row.only_numbers || row.count > 0) return false;
    return heading_seen_ = true;
  }

  void check_count() const {
    if (!counted_ || points_ >= announced_) return;
    input_.fail(
        fmt::format("is cut off: it announces {} points but holds {}.", announced_, points_));
  }

  ScanInput input_;
  bool counted_;  // in PTS files the counts are binding
  bool heading_seen_ = false;
  DecimalCommas commas_{{3, false}};
  std::uint64_t points_ = 0, announced_ = 0;
};

bool is_unit(const Eigen::Vector3d& vector) {
  return std::abs(vector.norm() - 1.0) <= unit_tolerance;
}

// The first column of the normals: three columns of unit vectors, right behind the point or at the
// end of the line, in all of the first points. Colours are no unit vectors.
std::optional<std::size_t> normal_column(const std::filesystem::path& path) {
  TextRows rows(path);
  TextRow row;
  if (!rows.next(row) || row.count < 6) return std::nullopt;
  const std::size_t columns = row.count;
  bool behind_point = true, at_end = true;
  for (int k = 0; k == 0 || (k < trial_points && rows.next(row)); ++k) {
    behind_point &= row.count == columns && is_unit(row.vector(3));
    at_end &= row.count == columns && is_unit(row.vector(columns - 3));
  }
  if (behind_point) return 3;
  if (at_end) return columns - 3;
  return std::nullopt;
}

}  // namespace

ScanFile read_scan_text(const std::filesystem::path& path, const ReadScanOptions& options) {
  const std::optional<std::size_t> column = normal_column(path);
  TextRows rows(path);
  ScanCollector collector(options);
  for (TextRow row; rows.next(row);) {
    const bool has_normal = column && row.count >= *column + 3;
    collector.add(row.vector(0), has_normal ? row.vector(*column) : Eigen::Vector3d::Zero());
  }
  return collector.finish("text");
}

}  // namespace bodyline::io
