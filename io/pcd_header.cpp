#include "io/pcd_header.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>

#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

constexpr int most_header_lines = 1000;
constexpr std::uint64_t largest_point = 1 << 16;  // bytes
constexpr std::array<const char*, 6> column_names{"x",        "y",        "z",
                                                  "normal_x", "normal_y", "normal_z"};

using Words = std::vector<std::string>;
using Entries = std::map<std::string, Words>;

Words all_words(std::string_view line) {
  Words words;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    words.emplace_back(word);
  }
  return words;
}

// The lines of the head by their first words, down to DATA.
Entries read_entries(ScanInput& input) {
  Entries entries;
  std::string_view line;
  for (int lines = 0; lines < most_header_lines && input.line(line); ++lines) {
    std::string keyword(next_word(line));
    if (keyword.empty() || keyword.starts_with('#')) continue;
    if (keyword == "COLUMNS") keyword = "FIELDS";  // version 0.5 and before
    if (entries.empty() && keyword != "VERSION" && keyword != "FIELDS") {
      input.fail_line("is not a PCD file: it does not begin with VERSION or FIELDS.");
    }
    entries[keyword] = all_words(line);
    if (keyword == "DATA") return entries;
  }
  input.fail("its head does not end: there is no line DATA.");
}

std::uint64_t whole_number(const ScanInput& input, const Entries& entries, const std::string& key,
                           std::size_t k) {
  std::uint64_t number = 0;
  const auto entry = entries.find(key);
  if (entry == entries.end() || entry->second.size() <= k ||
      !whole_from_word(entry->second[k], number)) {
    input.fail(fmt::format("its head needs a whole number as entry {} of {}.", k + 1, key));
  }
  return number;
}

std::optional<ScalarType> scalar_type(const std::string& kind, std::uint64_t size) {
  if (kind == "F" && size == 4) return ScalarType::float32;
  if (kind == "F" && size == 8) return ScalarType::float64;
  if (kind != "I" && kind != "U") return std::nullopt;
  const bool sign = kind == "I";
  switch (size) {
    case 1:
      return sign ? ScalarType::int8 : ScalarType::uint8;
    case 2:
      return sign ? ScalarType::int16 : ScalarType::uint16;
    case 4:
      return sign ? ScalarType::int32 : ScalarType::uint32;
    case 8:
      return sign ? ScalarType::int64 : ScalarType::uint64;
    default:
      return std::nullopt;
  }
}

ScalarType field_type(const ScanInput& input, const Entries& entries, std::size_t k) {
  const std::uint64_t size = whole_number(input, entries, "SIZE", k);
  const auto kinds = entries.find("TYPE");
  const bool known = kinds != entries.end() && kinds->second.size() > k;
  const auto type = known ? scalar_type(kinds->second[k], size) : std::nullopt;
  if (!type) input.fail(fmt::format("its head gives no usable TYPE and SIZE for field {}.", k + 1));
  return *type;
}

void read_fields(const ScanInput& input, const Entries& entries, PcdHeader& header) {
  const auto fields = entries.find("FIELDS");
  if (fields == entries.end()) input.fail("its head has no line FIELDS.");
  std::size_t words = 0;
  for (std::size_t k = 0; k < fields->second.size(); ++k) {
    const ScalarType type = field_type(input, entries, k);
    const std::uint64_t count =
        entries.contains("COUNT") ? whole_number(input, entries, "COUNT", k) : 1;
    for (std::size_t c = 0; c < column_names.size(); ++c) {
      if (fields->second[k] != column_names[c] || count != 1) continue;
      header.columns[c] = {true, type, words, header.point_size};
    }
    if (count > largest_point) input.fail("its points are larger than 64 KiB.");
    words += count;
    header.point_size += count * scalar_size(type);
    if (header.point_size > largest_point) input.fail("its points are larger than 64 KiB.");
  }
  for (std::size_t c = 0; c < 3; ++c) {
    if (!header.columns[c].present) {
      input.fail(fmt::format("its points have no field \"{}\".", column_names[c]));
    }
  }
}

PcdData data_kind(const ScanInput& input, const Words& words) {
  const std::string kind = words.empty() ? "" : words.front();
  if (kind == "ascii") return PcdData::ascii;
  if (kind == "binary") return PcdData::binary;
  if (kind == "binary_compressed") return PcdData::compressed;
  input.fail_line(shown_word(kind) +
                  " is not a kind of DATA; those are ascii, binary and binary_compressed.");
}

}  // namespace

PcdHeader read_pcd_header(ScanInput& input) {
  const Entries entries = read_entries(input);
  PcdHeader header;
  header.data = data_kind(input, entries.at("DATA"));
  read_fields(input, entries, header);
  if (entries.contains("POINTS")) {
    header.points = whole_number(input, entries, "POINTS", 0);
  } else {
    const std::uint64_t width = whole_number(input, entries, "WIDTH", 0);
    const std::uint64_t height = whole_number(input, entries, "HEIGHT", 0);
    if (width > UINT32_MAX || height > UINT32_MAX) input.fail("its WIDTH or HEIGHT is too large.");
    header.points = width * height;
  }
  return header;
}

}  // namespace bodyline::io
