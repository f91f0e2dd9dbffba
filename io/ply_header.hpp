#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/scalar_type.hpp"
#include "io/scan_input.hpp"

namespace bodyline::io {

/// One number of an element, or a list of them behind its length.
struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::optional<ScalarType> length_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< as the file claims
  std::vector<PlyProperty> properties;

  /// Position of a property, -1 when there is none. `list` says which kind is meant.
  int find(const std::string& property, bool list) const;
};

/// The head of a PLY file (G. Turk, The PLY polygon file format, 1994).
struct PlyHeader {
  bool ascii = true;
  ByteOrder order = ByteOrder::little;
  std::vector<PlyElement> elements;

  /// nullptr when there is none.
  const PlyElement* find(const std::string& element) const;
};

/// Reads the head; the input then stands at the first element. Throws InputError.
PlyHeader read_ply_header(ScanInput& input);

}  // namespace bodyline::io
