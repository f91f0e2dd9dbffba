#pragma once

#include <cstddef>

namespace bodyline::io {

/// How binary files store one number.
enum class ScalarType {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

enum class ByteOrder { little, big };

/// Bytes of one number.
std::size_t scalar_size(ScalarType type);

/// The number whose first byte is at `bytes`, which need not be aligned.
double scalar_from_bytes(const char* bytes, ScalarType type, ByteOrder order);

}  // namespace bodyline::io
