#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/scalar_type.hpp"
#include "io/scan_input.hpp"

namespace bodyline::io {

enum class PcdData { ascii, binary, compressed };

/// One of the numbers x y z normal_x normal_y normal_z in a PCD file.
struct PcdColumn {
  bool present = false;
  ScalarType type = ScalarType::float32;
  std::size_t word = 0;    ///< its place among the words of a line
  std::size_t offset = 0;  ///< its first byte within a point
};

/// The head of a PCD file, version 0.6 and 0.7.
struct PcdHeader {
  PcdData data = PcdData::ascii;
  std::uint64_t points = 0;    ///< as the file claims
  std::size_t point_size = 0;  ///< bytes
  std::array<PcdColumn, 6> columns;

  bool has_normals() const {
    return columns[3].present && columns[4].present && columns[5].present;
  }
};

/// Reads the head; the input then stands at the first point. Throws InputError.
PcdHeader read_pcd_header(ScanInput& input);

}  // namespace bodyline::io
