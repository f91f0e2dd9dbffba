#include "io/read_scan_pcd.hpp"

#include <fmt/format.h>

#include "io/lzf.hpp"
#include "io/pcd_header.hpp"
#include "io/scan_collector.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

// A compressed file has to be unpacked whole, column after column.
constexpr std::uint64_t most_unpacked = std::uint64_t{1} << 30;

using Numbers = std::array<double, 6>;

void add(ScanCollector& collector, const PcdHeader& header, const Numbers& numbers) {
  const Eigen::Vector3d point(numbers[0], numbers[1], numbers[2]);
  if (header.has_normals()) {
    collector.add(point, {numbers[3], numbers[4], numbers[5]});
  } else {
    collector.add(point);
  }
}

[[noreturn]] void fail_end(const ScanInput& input, std::uint64_t points, const PcdHeader& header) {
  input.fail(fmt::format("is cut off: it ends after {} of {} points.", points, header.points));
}

Numbers numbers_from_line(const ScanInput& input, const PcdHeader& header, std::string_view line) {
  Numbers numbers{};
  std::array<bool, 6> found{};
  std::string_view rest = line;
  std::size_t place = 0;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest), ++place) {
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      if (!header.columns[c].present || header.columns[c].word != place) continue;
      found[c] = number_from_word(word, numbers[c]);
      if (!found[c]) input.fail_line(shown_word(word) + " is not a number.");
    }
  }
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    if (header.columns[c].present && !found[c]) {
      input.fail_line(fmt::format("holds {} numbers, too few for a point.", place));
    }
  }
  return numbers;
}

void read_ascii(ScanInput& input, const PcdHeader& header, ScanCollector& collector) {
  std::string_view line;
  for (std::uint64_t k = 0; k < header.points; ++k) {
    if (!input.filled_line(line)) fail_end(input, k, header);
    add(collector, header, numbers_from_line(input, header, line));
  }
}

void read_binary(ScanInput& input, const PcdHeader& header, ScanCollector& collector) {
  for (std::uint64_t k = 0; k < header.points; ++k) {
    const char* const bytes = input.bytes(header.point_size);
    if (bytes == nullptr) fail_end(input, k, header);
    Numbers numbers{};
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      const PcdColumn& column = header.columns[c];
      if (!column.present) continue;
      numbers[c] = scalar_from_bytes(bytes + column.offset, column.type, ByteOrder::little);
    }
    add(collector, header, numbers);
  }
}

std::uint64_t read_size(ScanInput& input) {
  const char* const bytes = input.bytes(4);
  if (bytes == nullptr) input.fail("is cut off: it ends before its points.");
  return static_cast<std::uint64_t>(
      scalar_from_bytes(bytes, ScalarType::uint32, ByteOrder::little));
}

std::string read_unpacked(ScanInput& input, const PcdHeader& header) {
  const std::uint64_t packed_size = read_size(input), size = read_size(input);
  if (size > most_unpacked) input.fail("is too large for a compressed file; save it as binary.");
  if (header.points > most_unpacked || size != header.points * header.point_size) {
    input.fail(fmt::format("unpacks to {} bytes, but its head announces {} points of {} bytes.",
                           size, header.points, header.point_size));
  }
  if (packed_size > input.size() - input.offset()) {
    input.fail("is cut off: it ends within its compressed points.");
  }
  const char* const packed = input.bytes(packed_size);
  std::string unpacked;
  if (packed != nullptr) unpacked = unpacked_lzf({packed, packed_size}, size);
  if (unpacked.size() != size) input.fail("its compressed points are damaged.");
  return unpacked;
}

void read_compressed(ScanInput& input, const PcdHeader& header, ScanCollector& collector) {
  const std::string unpacked = read_unpacked(input, header);
  for (std::uint64_t k = 0; k < header.points; ++k) {
    Numbers numbers{};
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      const PcdColumn& column = header.columns[c];
      if (!column.present) continue;
      const char* const bytes =
          unpacked.data() + header.points * column.offset + k * scalar_size(column.type);
      numbers[c] = scalar_from_bytes(bytes, column.type, ByteOrder::little);
    }
    add(collector, header, numbers);
  }
}

}  // namespace

ScanFile read_scan_pcd(const std::filesystem::path& path, const ReadScanOptions& options) {
  ScanInput input(path);
  const PcdHeader header = read_pcd_header(input);
  ScanCollector collector(options);
  switch (header.data) {
    case PcdData::ascii:
      read_ascii(input, header, collector);
      return collector.finish("PCD, ASCII");
    case PcdData::binary:
      read_binary(input, header, collector);
      return collector.finish("PCD, binary");
    case PcdData::compressed:
      read_compressed(input, header, collector);
      return collector.finish("PCD, compressed");
  }
  return {};
}

}  // namespace bodyline::io
