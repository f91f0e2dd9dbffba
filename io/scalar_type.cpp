#include "io/scalar_type.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace bodyline::io {
namespace {

constexpr ByteOrder native =
    std::endian::native == std::endian::little ? ByteOrder::little : ByteOrder::big;

template <typename Number>
double number_from_bytes(const char* bytes, ByteOrder order) {
  std::array<char, sizeof(Number)> copy;
  std::memcpy(copy.data(), bytes, sizeof(Number));
  if (order != native) std::reverse(copy.begin(), copy.end());
  return static_cast<double>(std::bit_cast<Number>(copy));
}

}  // namespace

std::size_t scalar_size(ScalarType type) {
  switch (type) {
    case ScalarType::int8:
    case ScalarType::uint8:
      return 1;
    case ScalarType::int16:
    case ScalarType::uint16:
      return 2;
    case ScalarType::int32:
    case ScalarType::uint32:
    case ScalarType::float32:
      return 4;
    case ScalarType::int64:
    case ScalarType::uint64:
    case ScalarType::float64:
      return 8;
  }
  return 0;
}

double scalar_from_bytes(const char* bytes, ScalarType type, ByteOrder order) {
  switch (type) {
    case ScalarType::int8:
      return number_from_bytes<std::int8_t>(bytes, order);
    case ScalarType::uint8:
      return number_from_bytes<std::uint8_t>(bytes, order);
    case ScalarType::int16:
      return number_from_bytes<std::int16_t>(bytes, order);
    case ScalarType::uint16:
      return number_from_bytes<std::uint16_t>(bytes, order);
    case ScalarType::int32:
      return number_from_bytes<std::int32_t>(bytes, order);
    case ScalarType::uint32:
      return number_from_bytes<std::uint32_t>(bytes, order);
    case ScalarType::int64:
      return number_from_bytes<std::int64_t>(bytes, order);
    case ScalarType::uint64:
      return number_from_bytes<std::uint64_t>(bytes, order);
    case ScalarType::float32:
      return number_from_bytes<float>(bytes, order);
    case ScalarType::float64:
      return number_from_bytes<double>(bytes, order);
  }
  return 0.0;
}

}  // namespace bodyline::io
