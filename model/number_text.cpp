#include "model/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace bodyline::model {

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  char* const first = buffer.data();
  char* const last = first + buffer.size();
  constexpr double largest_plain = 1e15;
  const bool whole = std::abs(value) <= largest_plain && std::floor(value) == value;
  return {first, whole ? std::to_chars(first, last, value, std::chars_format::fixed).ptr
                       : std::to_chars(first, last, value).ptr};
}

}  // namespace bodyline::model
