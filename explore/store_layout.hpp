#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "explore/design_space.hpp"
#include "explore/study.hpp"
#include "explore/variant_rows.hpp"

namespace bodyline::explore {

/// Version of the layout that docs/store.md describes.
inline constexpr int store_schema = 1;

enum class ElementType { float64, float32, uint16, uint8, status };
std::size_t element_bytes(ElementType type);

/// One dataset of which every variant has a row.
struct TableLayout {
  std::string name;  ///< "variables", ...
  ElementType type = ElementType::float64;
  std::vector<std::uint64_t> row;  ///< shape of a row; empty: one element
  int chunk_rows = 1;              ///< divides the block

  std::size_t row_elements() const;
  std::size_t row_bytes() const { return row_elements() * element_bytes(type); }
  std::size_t chunk_bytes() const { return std::size_t(chunk_rows) * row_bytes(); }
};

/// What the store of a study looks like; all of it follows from the study.
struct StoreLayout {
  StoreLayout(const Study& study, const DesignSpace& space);

  int block_rows = 1;  ///< rows that are written at once, a power of two
  bool compressed = true;
  std::vector<TableLayout> tables;
};

/// Height, width and colour channels of thumbnails that are so wide.
std::vector<std::uint64_t> thumbnail_shape(int width);

/// The bytes of a table's rows in `rows`: count * row_bytes().
const std::byte* table_data(const VariantRows& rows, const std::string& table);
std::byte* table_data(VariantRows& rows, const std::string& table);

/// Rows of the layout's shape, all zero.
VariantRows make_rows(const StoreLayout& layout, std::uint64_t first, int count);

/// Copies `count` rows of all tables.
void copy_rows(const StoreLayout& layout, const VariantRows& from, int from_row, VariantRows& to,
               int to_row, int count);

}  // namespace bodyline::explore
