#include "explore/block_codec.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

namespace bodyline::explore {
namespace {

using Bytes = std::vector<std::byte>;

// Deflating takes ten times as long as storing unless most bytes repeat, and then gains little: the
// last digits of numbers are noise.
constexpr double least_repeated = 0.85;
constexpr double rows_alike = 0.95;
constexpr std::size_t sampled_bytes = 2048;

// Exchanges the upper bits of the lower number and the lower bits of the upper one, within fields
// of twice so many.
void exchange(std::uint64_t& lower, std::uint64_t& upper, int bits, std::uint64_t low_bits) {
  const std::uint64_t difference = ((lower >> bits) ^ upper) & low_bits;
  upper ^= difference;
  lower ^= difference << bits;
}

// Byte p of number k to byte k of number p, of eight numbers of eight bytes.
void transpose_bytes(std::uint64_t* numbers) {
  for (int k = 0; k < 4; ++k) exchange(numbers[k], numbers[k + 4], 32, 0x00000000FFFFFFFF);
  for (const int k : {0, 1, 4, 5}) exchange(numbers[k], numbers[k + 2], 16, 0x0000FFFF0000FFFF);
  for (const int k : {0, 2, 4, 6}) exchange(numbers[k], numbers[k + 1], 8, 0x00FF00FF00FF00FF);
}

// Bytes of equal significance together, as the filter `shuffle` has them.
std::unique_ptr<std::byte[]> shuffled(const std::byte* data, std::size_t count,
                                      std::size_t element) {
  auto planes = std::make_unique_for_overwrite<std::byte[]>(count * element);
  std::size_t done = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::uint64_t eight[8];
    for (; element == sizeof eight[0] && done + 8 <= count; done += 8) {
      std::memcpy(eight, data + done * element, sizeof eight);
      transpose_bytes(eight);
      for (std::size_t p = 0; p < 8; ++p)
        std::memcpy(planes.get() + p * count + done, &eight[p], sizeof eight[p]);
    }
  }
  for (std::size_t p = 0; p < element; ++p) {
    std::byte* const plane = planes.get() + p * count;
    for (std::size_t k = done; k < count; ++k) plane[k] = data[k * element + p];
  }
  return planes;
}

// How zlib shall treat a plane.
struct Method {
  int level = Z_NO_COMPRESSION;
  int strategy = Z_DEFAULT_STRATEGY;
  bool operator==(const Method&) const = default;
};

// By how many bytes of a plane are what the byte before, or that of the row before, is.
Method method_for(const std::byte* plane, std::size_t count, std::size_t row) {
  if (count <= row) return {};
  const std::size_t stride = std::max<std::size_t>(1, (count - row) / sampled_bytes);
  std::size_t sampled = 0, repeated = 0, as_in_row_before = 0;
  for (std::size_t k = row; k < count; k += stride, ++sampled) {
    const bool row_before = plane[k] == plane[k - row];
    as_in_row_before += row_before;
    repeated += row_before || plane[k] == plane[k - 1];
  }
  if (double(repeated) < least_repeated * double(sampled)) return {};
  // Without long repetitions of rows to look for, runs and frequencies tell as much, in less time.
  const bool rows_repeat = double(as_in_row_before) >= rows_alike * double(sampled);
  return {Z_BEST_SPEED, rows_repeat ? Z_DEFAULT_STRATEGY : Z_RLE};
}

// A zlib stream in which each plane has the method that suits it.
class PlaneDeflater {
 public:
  explicit PlaneDeflater(std::size_t bytes) {
    if (deflateInit(&stream_, Z_BEST_SPEED) != Z_OK) throw std::bad_alloc();
    // Stored blocks and the switches between methods add a little to what zlib expects.
    out_.resize(deflateBound(&stream_, bytes) + bytes / 1024 + 1024);
    stream_.next_out = reinterpret_cast<Bytef*>(out_.data());
    stream_.avail_out = uInt(out_.size());
  }
  PlaneDeflater(const PlaneDeflater&) = delete;
  PlaneDeflater& operator=(const PlaneDeflater&) = delete;
  ~PlaneDeflater() { deflateEnd(&stream_); }

  void add(const std::byte* plane, std::size_t count, const Method& wanted) {
    if (wanted != method_) check(deflateParams(&stream_, wanted.level, wanted.strategy));
    method_ = wanted;
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(plane));
    stream_.avail_in = uInt(count);
    check(deflate(&stream_, Z_NO_FLUSH));
  }

  Bytes finish() {
    if (deflate(&stream_, Z_FINISH) != Z_STREAM_END) throw std::logic_error("zlib has no room");
    out_.resize(stream_.total_out);
    return std::move(out_);
  }

 private:
  static void check(int code) {
    if (code != Z_OK) throw std::logic_error("zlib refuses to go on");
  }

  z_stream stream_{};
  Method method_{Z_BEST_SPEED, Z_DEFAULT_STRATEGY};
  Bytes out_;
};

Bytes compressed(const std::byte* data, const TableLayout& table) {
  const std::size_t element = element_bytes(table.type), row = table.row_elements();
  const std::size_t count = std::size_t(table.chunk_rows) * row;
  const auto planes = shuffled(data, count, element);
  PlaneDeflater deflater(count * element);
  for (std::size_t p = 0; p < element; ++p) {
    const std::byte* const plane = planes.get() + p * count;
    deflater.add(plane, count, method_for(plane, count, row));
  }
  return deflater.finish();
}

}  // namespace

EncodedBlock encode_block(const StoreLayout& layout, const VariantRows& rows) {
  EncodedBlock block{rows.first, rows.count, {}};
  for (const TableLayout& table : layout.tables) {
    auto& chunks = block.chunks.emplace_back();
    const std::byte* const data = table_data(rows, table.name);
    for (int row = 0; row < rows.count; row += table.chunk_rows) {
      const std::byte* first = data + std::size_t(row) * table.row_bytes();
      Bytes filled;
      if (row + table.chunk_rows > rows.count) {
        filled.assign(first, data + std::size_t(rows.count) * table.row_bytes());
        filled.resize(table.chunk_bytes());
        first = filled.data();
      }
      if (layout.compressed) {
        chunks.push_back(compressed(first, table));
      } else {
        chunks.emplace_back(first, first + table.chunk_bytes());
      }
    }
  }
  return block;
}

}  // namespace bodyline::explore
