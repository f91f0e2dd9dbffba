#pragma once

#include "io/ply_header.hpp"

namespace bodyline::io {

/// The numbers behind the head of a PLY file, one after the other, text or binary.
class PlyValues {
 public:
  PlyValues(ScanInput& input, const PlyHeader& header) : input_(input), header_(header) {}

  /// Goes to an element before its numbers are read. Throws InputError when the file ends.
  void begin(const PlyElement& element, std::uint64_t index);

  /// The next number. Throws InputError.
  double next(ScalarType type);

  /// The length of a list, the next number. Throws InputError when it is not a whole one.
  std::uint64_t next_length(ScalarType type);

  /// Throws InputError that names the place of the element.
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  [[noreturn]] void fail_end() const;

  ScanInput& input_;
  const PlyHeader& header_;
  const PlyElement* element_ = nullptr;
  std::uint64_t index_ = 0;
  std::string_view line_;
};

}  // namespace bodyline::io
