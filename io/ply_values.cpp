#include "io/ply_values.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/scan_words.hpp"

namespace bodyline::io {

void PlyValues::begin(const PlyElement& element, std::uint64_t index) {
  element_ = &element;
  index_ = index;
  if (header_.ascii && !input_.filled_line(line_)) fail_end();
}

double PlyValues::next(ScalarType type) {
  if (!header_.ascii) {
    const char* const bytes = input_.bytes(scalar_size(type));
    if (bytes == nullptr) fail_end();
    return scalar_from_bytes(bytes, type, header_.order);
  }
  const std::string_view word = next_word(line_);
  double value = 0.0;
  if (word.empty()) fail("holds fewer numbers than " + shown_word(element_->name) + " has.");
  if (!number_from_word(word, value)) fail(shown_word(word) + " is not a number.");
  return value;
}

std::uint64_t PlyValues::next_length(ScalarType type) {
  constexpr double longest = 4294967295.0;
  const double length = next(type);
  if (!(length >= 0.0 && length <= longest && length == std::floor(length))) {
    fail(fmt::format("a list cannot have the length {}.", length));
  }
  return static_cast<std::uint64_t>(length);
}

void PlyValues::fail(const std::string& sentence) const {
  if (header_.ascii) input_.fail_line(sentence);
  input_.fail(fmt::format("at byte {}: {}", input_.offset(), sentence));
}

void PlyValues::fail_end() const {
  input_.fail(fmt::format("is cut off: it ends after {} of {} elements {}.", index_,
                          element_->count, shown_word(element_->name)));
}

}  // namespace bodyline::io
