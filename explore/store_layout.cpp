#include "explore/store_layout.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace bodyline::explore {
namespace {

constexpr std::size_t usual_chunk_bytes = std::size_t(1) << 20;  // what HDF5 caches of a dataset
constexpr int least_block = 64, most_block = 4096;
constexpr std::uint64_t channels = 3;  // of a picture
constexpr int least_height = 64;       // that io::render draws

int rows_within(std::size_t bytes, std::size_t row_bytes) {
  return int(std::bit_floor(std::max<std::size_t>(1, bytes / std::max<std::size_t>(1, row_bytes))));
}

template <class Rows>
auto* data_of(Rows& rows, const std::string& table) {
  using Byte = std::conditional_t<std::is_const_v<Rows>, const std::byte, std::byte>;
  const auto bytes = [](auto& values) { return reinterpret_cast<Byte*>(values.data()); };
  if (table == "variables") return bytes(rows.values);
  if (table == "metrics") return bytes(rows.metrics);
  if (table == "status") return bytes(rows.status);
  if (table == "cause") return bytes(rows.cause);
  if (table == "seconds") return bytes(rows.seconds);
  if (table == "nets") return bytes(rows.nets);
  if (table == "thumbnails") return bytes(rows.thumbnails);
  throw std::logic_error("a store has no table " + table);
}

void resize(VariantRows& rows, const TableLayout& table) {
  const std::size_t count = std::size_t(rows.count) * table.row_elements();
  if (table.name == "variables") rows.values.resize(count);
  if (table.name == "metrics") rows.metrics.resize(count);
  if (table.name == "status") rows.status.resize(count);
  if (table.name == "cause") rows.cause.resize(count);
  if (table.name == "seconds") rows.seconds.resize(count);
  if (table.name == "nets") rows.nets.resize(count);
  if (table.name == "thumbnails") rows.thumbnails.resize(count);
}

}  // namespace

std::size_t element_bytes(ElementType type) {
  switch (type) {
    case ElementType::float64:
      return 8;
    case ElementType::float32:
      return 4;
    case ElementType::uint16:
      return 2;
    case ElementType::uint8:
    case ElementType::status:
      return 1;
  }
  return 0;
}

std::size_t TableLayout::row_elements() const {
  std::size_t count = 1;
  for (const std::uint64_t extent : row) count *= extent;
  return count;
}

std::vector<std::uint64_t> thumbnail_shape(int width) {
  return {std::uint64_t(std::max(least_height, width * 9 / 16)), std::uint64_t(width), channels};
}

StoreLayout::StoreLayout(const Study& study, const DesignSpace& space)
    : compressed(study.keep.compressed) {
  tables.push_back({"variables", ElementType::float64, {std::uint64_t(space.column_count())}, 1});
  tables.push_back({"metrics", ElementType::float64, {study.metrics.size()}, 1});
  tables.push_back({"status", ElementType::status, {}, 1});
  tables.push_back({"cause", ElementType::uint16, {}, 1});
  tables.push_back({"seconds", ElementType::float32, {}, 1});
  if (study.keep.nets) {
    const std::uint64_t points = std::uint64_t(space.context()->plan.point_count);
    tables.push_back({"nets", ElementType::float32, {points, 3}, 1});
  }
  if (study.keep.thumbnail_width > 0) {
    tables.push_back(
        {"thumbnails", ElementType::uint8, thumbnail_shape(study.keep.thumbnail_width), 1});
  }
  const int usual = rows_within(usual_chunk_bytes, tables.front().row_bytes());
  block_rows = study.keep.block > 0 ? study.keep.block : std::clamp(usual, least_block, most_block);
  for (TableLayout& table : tables)
    table.chunk_rows = std::min(block_rows, rows_within(usual_chunk_bytes, table.row_bytes()));
}

const std::byte* table_data(const VariantRows& rows, const std::string& table) {
  return data_of(rows, table);
}

std::byte* table_data(VariantRows& rows, const std::string& table) { return data_of(rows, table); }

VariantRows make_rows(const StoreLayout& layout, std::uint64_t first, int count) {
  VariantRows rows;
  rows.first = first;
  rows.count = count;
  for (const TableLayout& table : layout.tables) resize(rows, table);
  return rows;
}

void copy_rows(const StoreLayout& layout, const VariantRows& from, int from_row, VariantRows& to,
               int to_row, int count) {
  for (const TableLayout& table : layout.tables) {
    const std::size_t size = table.row_bytes();
    std::memcpy(table_data(to, table.name) + std::size_t(to_row) * size,
                table_data(from, table.name) + std::size_t(from_row) * size,
                std::size_t(count) * size);
  }
}

}  // namespace bodyline::explore
